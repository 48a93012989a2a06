// A surface as a program in C, C++, Fortran or Python, or as a surface file: the text that the page computes with.
import { real, textOf } from "./fields.js";

/** The lines of a text as strings of C. */
const quoted = (text, indent) => text.trimEnd().split("\n").map((line) => `${JSON.stringify(`${line}\n`)}`).join(`\n${indent}`);

const c = (text, load) => `/* cc friction.c $(pkg-config --cflags --libs asperity) */
#include <asperity.h>
#include <stdio.h>

static const char surface[] =
    ${quoted(text, "    ")};

int main(void) {
    asperity_params params;
    asperity_model *model;
    asperity_params_init(&params, sizeof params);
    if (asperity_params_set_text(&params, surface, sizeof surface - 1) != ASPERITY_OK || asperity_create(&params, &model) != ASPERITY_OK) {
        char message[512];
        asperity_last_error(message, sizeof message);
        fprintf(stderr, "%s\\n", message);
        return 1;
    }
    printf("%.10g\\n", asperity_friction_at_load(model, ${load})); /* load [N] */
    asperity_free(model);
}
`;

const cpp = (text, load) => `// c++ -std=c++17 friction.cpp $(pkg-config --cflags --libs asperity)
#include <asperity.hpp>

#include <cstdio>
#include <exception>

constexpr char surface[] =
    ${quoted(text, "    ")};

int main() try {
    const asperity::Model model(asperity::Params().set_text(surface));
    std::printf("%.10g\\n", model.friction_at_load(${load})); // load [N]
} catch (const std::exception &error) {
    std::fprintf(stderr, "%s\\n", error.what());
    return 1;
}
`;

const fortran = (text, load) => `! To be compiled with asperity.f90 and linked with -lasperity
program friction
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity
  implicit none
  type(asperity_params) :: params
  type(friction_model) :: law
  character(*), parameter :: n = new_line('a')

  call asperity_check(asperity_params_init(params))
  call asperity_params_set_text(params, &
    ${text.trimEnd().split("\n").map((line) => `'${line.replaceAll("'", "''")}' // n`).join(" // &\n    ")})
  call law%create(params)
  write (*, '(es17.9)') law%friction_at_load(${load}_c_double)  ! load [N]
  call law%free()
end program friction
`;

const python = (text, load) => `from asperity import Model, Params

surface = """
${text.trimEnd().replaceAll("\\", "\\\\")}
"""
model = Model(Params.from_text(surface))
print(f"{model.friction_at_load(${load}):.10g}")  # load in N
`;

/** The languages, with the name of the file that the text is for. */
export const LANGUAGES = {
  "surface.toml": { file: "surface.toml", text: (text) => text },
  C: { file: "friction.c", text: c },
  "C++": { file: "friction.cpp", text: cpp },
  Fortran: { file: "friction.f90", text: fortran },
  Python: { file: "friction.py", text: python },
};

/** The surface in a language; the programs print the friction coefficient at a load. */
export const snippet = (library, language, surface, load) => LANGUAGES[language].text(textOf(library, surface), load && real(load));
