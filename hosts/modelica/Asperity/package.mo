package Asperity "Friction from contact physics"
  class Law "A friction law"
    extends ExternalObject;

    function constructor
      input Real E1(unit = "Pa");
      input Real nu1;
      input Real E2(unit = "Pa");
      input Real nu2;
      input Real w(unit = "J/m2") "Work of adhesion";
      input Real h(unit = "m") "Range of adhesion";
      input Real b(unit = "m") "Burgers vector";
      input Real sigma(unit = "m") "Standard deviation of summit heights";
      input Real R(unit = "m") "Mean radius of the summits";
      input Real n "Number of summits";
      input Real pressure_coefficient = 0 "Part of the strength that grows with pressure";
      input Real calibration_load(unit = "N") = 0 "Load at which friction was measured; 0: nobody measured it";
      input Real calibration_friction_coefficient = 0 "Measured at this load";
      input Real calibration_friction_force(unit = "N") = 0 "Measured at this load, instead of the coefficient";
      output Law law;
      external "C" law = asperity_modelica_create(E1, nu1, E2, nu2, w, h, b, sigma, R, n,
        pressure_coefficient, calibration_load, calibration_friction_coefficient, calibration_friction_force)
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
