"""What a mock-up unit says of itself: its interfaces, variables and dependencies, in the XML of FMI 2.0 and of 3.0."""

from __future__ import annotations

from typing import Mapping
from xml.sax.saxutils import quoteattr

from .. import _header

# Meaning and inputs that it depends on.
_OUTPUTS = {
    "friction_force": ("F [force]", ["load"]),
    "friction_coefficient": ("F/load, capped", ["load"]),
    "slope": ("dF/d(load)", ["load"]),
}
_MICROSLIP_OUTPUTS = {
    "tangential_force": ("resists the displacement, from the last accepted step [force]", ["load", "displacement"]),
    "tangential_stiffness": ("d(tangential_force)/d(displacement) [force/length]", ["load", "displacement"]),
}


def model_description(
    fmi: str, name: str, guid: str, start_load: float, meanings: Mapping[str, str], starts: Mapping[str, float],
    microslip: bool = False,
) -> str:  # fmt: skip
    """modelDescription.xml; `meanings` are those of the parameters, in the order of their value references."""
    two = fmi == "2.0"
    references: dict[str, int] = {}
    variables: list[str] = []
    known: dict[str, list[str]] = {}  # inputs of each output

    def add_input(input: str, meaning: str, start: float) -> None:
        references[input] = len(variables)
        variables.append(_variable(two, input, len(variables), meaning, "input", "continuous", start=start))

    def add_outputs(outputs: Mapping[str, tuple[str, list[str]]]) -> None:
        for output, (meaning, inputs) in outputs.items():
            references[output], known[output] = len(variables), inputs
            variables.append(_variable(two, output, len(variables), meaning, "output", "continuous", initial="calculated"))

    add_input("load", "normal load [force]", start_load)
    add_outputs(_OUTPUTS)
    if microslip:
        add_input("displacement", "of the surfaces along each other [length]; at 0 the contact is unstrained", 0.0)
        add_outputs(_MICROSLIP_OUTPUTS)
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
        outputs = "".join(
            f'<Unknown index="{references[output] + 1}" dependencies="{" ".join(str(references[i] + 1) for i in inputs)}" '
            f'dependenciesKind="{" ".join("dependent" for _ in inputs)}"/>'
            for output, inputs in known.items()
        )
        initial = "".join(f'<Unknown index="{references[output] + 1}"/>' for output in known)
        structure = f"<Outputs>{outputs}</Outputs>\n    <InitialUnknowns>{initial}</InitialUnknowns>"
    else:
        identity, derivatives, events = "instantiationToken", "providesDirectionalDerivatives", ""
        memory, files = "", ""
        outputs = "".join(
            f'<Output valueReference="{references[output]}" dependencies="{" ".join(str(references[i]) for i in inputs)}" '
            f'dependenciesKind="{" ".join("dependent" for _ in inputs)}"/>'
            for output, inputs in known.items()
        )
        structure = outputs + "\n    " + "".join(f'<InitialUnknown valueReference="{references[output]}"/>' for output in known)
    state = "FMUstate" if two else "FMUState"
    unit = f'modelIdentifier="{name}"{memory} canGetAndSet{state}="true" canSerialize{state}="true" {derivatives}="true"'
    # What a contact remembers moves on with accepted steps; in FMI 2.0 an importer tells of them unless it is told not to.
    accepts = ' needsCompletedIntegratorStep="true"' if microslip and not two else ""
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="{fmi}" modelName="{name}" {identity}="{guid}"{events}
    description="Friction of two rough surfaces as a function of the normal load{" and the displacement" if microslip else ""}"
    generationTool="asperity {_header.ASPERITY_VERSION}" variableNamingConvention="flat">
  <ModelExchange {unit}{accepts}>{files}</ModelExchange>
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
