"""What a mock-up unit says of itself: its interfaces, variables and dependencies, in the XML of FMI 2.0 and of 3.0."""

from __future__ import annotations

from typing import Mapping
from xml.sax.saxutils import quoteattr

from . import _header

_OUTPUTS = {
    "friction_force": "F [force]",
    "friction_coefficient": "F/load, capped",
    "slope": "dF/d(load)",
}


def model_description(
    fmi: str, name: str, guid: str, start_load: float, meanings: Mapping[str, str], starts: Mapping[str, float]
) -> str:
    """modelDescription.xml; `meanings` are those of the parameters, in the order of their value references."""
    two = fmi == "2.0"
    variables = [_variable(two, "load", 0, "normal load [force]", "input", "continuous", start=start_load)]
    for output, meaning in _OUTPUTS.items():
        variables.append(_variable(two, output, len(variables), meaning, "output", "continuous", initial="calculated"))
    for parameter, meaning in meanings.items():
        variables.append(
            _variable(two, parameter, len(variables), meaning, "parameter", "tunable", start=starts[parameter])
        )
    if not two:
        variables.append(_variable(two, "time", len(variables), "[time]", "independent", "continuous"))
    listed = "\n    ".join(variables)
    if two:
        identity, derivatives, events = "guid", "providesDirectionalDerivative", ' numberOfEventIndicators="0"'
        memory, files = ' canNotUseMemoryManagementFunctions="true"', '<SourceFiles><File name="asperity_fmu.c"/></SourceFiles>'
        outputs = "".join(f'<Unknown index="{i}" dependencies="1" dependenciesKind="dependent"/>' for i in (2, 3, 4))
        initial = "".join(f'<Unknown index="{i}"/>' for i in (2, 3, 4))
        structure = f"<Outputs>{outputs}</Outputs>\n    <InitialUnknowns>{initial}</InitialUnknowns>"
    else:
        identity, derivatives, events = "instantiationToken", "providesDirectionalDerivatives", ""
        memory, files = "", ""
        outputs = "".join(
            f'<Output valueReference="{i}" dependencies="0" dependenciesKind="dependent"/>' for i in (1, 2, 3)
        )
        structure = outputs + "\n    " + "".join(f'<InitialUnknown valueReference="{i}"/>' for i in (1, 2, 3))
    unit = f'modelIdentifier="{name}"{memory} {derivatives}="true"'
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="{fmi}" modelName="{name}" {identity}="{guid}"{events}
    description="Friction of two rough surfaces as a function of the normal load"
    generationTool="asperity {_header.ASPERITY_VERSION}" variableNamingConvention="flat">
  <ModelExchange {unit}>{files}</ModelExchange>
  <CoSimulation {unit} canHandleVariableCommunicationStepSize="true">{files}</CoSimulation>
  <LogCategories><Category name="logStatusWarning"/><Category name="logStatusError"/><Category name="logStatusDiscard"/></LogCategories>
  <DefaultExperiment startTime="0" stopTime="1"/>
  <ModelVariables>
    {listed}
  </ModelVariables>
  <ModelStructure>
    {structure}
  </ModelStructure>
</fmiModelDescription>
"""


def _variable(
    two: bool, name: str, reference: int, meaning: str, causality: str, variability: str, *,
    initial: str | None = None, start: float | None = None,
) -> str:  # fmt: skip
    attributes = f'name="{name}" valueReference="{reference}" causality="{causality}" variability="{variability}"'
    if initial is not None:
        attributes += f' initial="{initial}"'
    attributes += f" description={quoteattr(meaning)}"
    value = "" if start is None else f' start="{"INF" if start == float("inf") else repr(start)}"'
    return f"<ScalarVariable {attributes}><Real{value}/></ScalarVariable>" if two else f"<Float64 {attributes}{value}/>"


def build_description(name: str) -> str:
    """sources/buildDescription.xml of FMI 3.0."""
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="{name}">
    <SourceFileSet language="C99"><SourceFile name="asperity_fmu.c"/></SourceFileSet>
    <Library name="asperity" external="true"/>
  </BuildConfiguration>
</fmiBuildDescription>
"""
