package Asperity "Friction from contact physics"
  class Law "A friction law"
    extends ExternalObject;

    function constructor
      input String surface = "" "Path of a surface file";
      input String text = "" "Lines of a surface file: in place of one, or what changes it";
      output Law law;
      external "C" law = asperity_modelica_create(surface, text)
        annotation(Include = "#include \"asperity_modelica.h\"", Library = "asperity");
    end constructor;

    function destructor
      input Law law;
      external "C" asperity_modelica_free(law)
        annotation(Include = "#include \"asperity_modelica.h\"", Library = "asperity");
    end destructor;
  end Law;

  function frictionForce "Friction force at a normal load"
    input Law law;
    input Real load(unit = "N");
    output Real force(unit = "N");
    external "C" force = asperity_modelica_force(law, load)
      annotation(Include = "#include \"asperity_modelica.h\"", Library = "asperity");
    annotation(derivative(noDerivative = law) = frictionForce_der);
  end frictionForce;

  function frictionForce_der
    input Law law;
    input Real load(unit = "N");
    input Real der_load(unit = "N/s");
    output Real der_force(unit = "N/s");
  algorithm
    der_force := slope(law, load)*der_load;
  end frictionForce_der;

  function slope "d(friction force)/d(normal load)"
    input Law law;
    input Real load(unit = "N");
    output Real slope;
    external "C" slope = asperity_modelica_slope(law, load)
      annotation(Include = "#include \"asperity_modelica.h\"", Library = "asperity");
  end slope;
end Asperity;
