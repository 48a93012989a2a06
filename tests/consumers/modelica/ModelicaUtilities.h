/* What asperity_modelica.h uses of the header that a Modelica tool brings; the test stands for the tool. */
#ifndef MODELICA_UTILITIES_H
#define MODELICA_UTILITIES_H

void ModelicaFormatError(const char *format, ...);
void ModelicaFormatMessage(const char *format, ...);

#endif
