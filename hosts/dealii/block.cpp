// The pushed block of hosts/fenicsx in deal.II: elastic, on a penalty floor, of which each iteration of Newton's method has force and slope
// of friction from the law at the pressures of the nodes. It prints the reaction of the top and each node of the floor, step by step.
//
// usage: block SURFACE AREA YOUNG POISSON WIDTH HEIGHT ACROSS UP PENALTY ONSET [SIDEWAYS DOWN]...    (AREA: of the law, in the units of all)
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/matrix_tools.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "asperity.h"

using namespace dealii;

struct Node {
    types::global_dof_index x, y;
    double area;
};

class Block {
public:
    Block(const asperity_model *law, double law_area, double young, double poisson, Point<2> corner, std::vector<unsigned> elements,
          double penalty, double onset)
        : law(law), law_area(law_area), lightest(1e-6 * young), penalty(penalty), onset(onset), fe(FE_Q<2>(1), 2), dofs(mesh) {
        GridGenerator::subdivided_hyper_rectangle(mesh, elements, Point<2>(), corner, true);
        dofs.distribute_dofs(fe);
        DynamicSparsityPattern pattern(dofs.n_dofs());
        DoFTools::make_sparsity_pattern(dofs, pattern);
        sparsity.copy_from(pattern);
        elastic.reinit(sparsity), tangent.reinit(sparsity);
        for (Vector<double> *vector : {&u, &before, &rest}) vector->reinit(dofs.n_dofs());
        assemble(young * poisson / (1 + poisson) / (1 - 2 * poisson), young / 2 / (1 + poisson));
    }

    // One step, the top to where it must be, by Newton's method with a line search.
    void push(double sideways, double down) {
        before = u;
        find_rest();
        for (int iteration = 0; iteration < 100; iteration++) {
            std::map<types::global_dof_index, double> held;
            for (const Node &node : top) held[node.x] = sideways - u(node.x), held[node.y] = down - u(node.y);
            Vector<double> step(u.size()), right = rest;
            right *= -1;
            MatrixTools::apply_boundary_values(held, tangent, step, right);
            SparseDirectUMFPACK solver;
            solver.initialize(tangent);
            solver.vmult(step, right);
            const Vector<double> from_here = u;
            const double had = free_norm();
            for (double part = 1; part > 0.005; part /= 2) {
                u = from_here;
                u.add(part, step);
                find_rest();
                if (iteration == 0 || free_norm() < had) break;
            }
            if (iteration > 0 && std::none_of(floor.begin(), floor.end(), [&](const Node &node) { return pressure(node) > 0; }))
                throw std::runtime_error("no node touches");
            if (iteration > 0 && step.linfty_norm() < 1e-10 * u.linfty_norm()) return;
        }
        throw std::runtime_error("Newton's method does not converge");
    }

    void print() const {
        Vector<double> force(u.size());
        elastic.vmult(force, u);
        double on_top[2] = {0, 0};
        for (const Node &node : top) on_top[0] += force(node.x), on_top[1] += force(node.y);
        std::cout << on_top[0] << " " << on_top[1];
        for (const Node &node : floor) std::cout << " " << node.area << " " << pressure(node) << " " << u(node.x) - before(node.x);
        std::cout << "\n";
    }

private:
    void assemble(double lame, double shear) {
        const QGauss<2> points(2);
        FEValues<2> values(fe, points, update_gradients | update_JxW_values);
        const FEValuesExtractors::Vector displacement(0);
        FullMatrix<double> local(fe.n_dofs_per_cell(), fe.n_dofs_per_cell());
        std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
        std::map<types::global_dof_index, Node> nodes[2];
        for (const auto &cell : dofs.active_cell_iterators()) {
            values.reinit(cell);
            local = 0;
            for (const unsigned q : values.quadrature_point_indices())
                for (const unsigned i : values.dof_indices())
                    for (const unsigned j : values.dof_indices())
                        local(i, j) += (2 * shear * (values[displacement].symmetric_gradient(i, q) * values[displacement].symmetric_gradient(j, q)) +
                                        lame * values[displacement].divergence(i, q) * values[displacement].divergence(j, q)) * values.JxW(q);
            cell->get_dof_indices(indices);
            elastic.add(indices, local);
            for (const auto &face : cell->face_iterators())
                if (face->at_boundary() && face->boundary_id() >= 2)    // 2 below, 3 above
                    for (unsigned end = 0; end < 2; end++) {
                        const auto x = face->vertex_dof_index(end, 0), y = face->vertex_dof_index(end, 1);
                        Node &node = nodes[face->boundary_id() - 2].insert({x, {x, y, 0}}).first->second;
                        node.area += face->measure() / 2;
                    }
        }
        for (const auto &node : nodes[0]) floor.push_back(node.second);
        for (const auto &node : nodes[1]) top.push_back(node.second);
    }

    double pressure(const Node &node) const { return std::max(-penalty * u(node.y), 0.0); }

    double free_norm() const {
        Vector<double> free = rest;
        for (const Node &node : top) free(node.x) = free(node.y) = 0;
        return free.l2_norm();
    }

    // The residual and the tangent, with force and slope of the law at the pressures that the nodes have.
    void find_rest() {
        elastic.vmult(rest, u);
        tangent.copy_from(elastic);
        std::vector<double> load, force(floor.size()), slope(floor.size());
        for (const Node &node : floor) load.push_back(std::max(pressure(node), lightest * 1e-6) * law_area);
        if (asperity_friction_force_at_loads(law, load.size(), load.data(), force.data(), slope.data()) != ASPERITY_OK)
            throw std::runtime_error("a pressure that the law does not know");
        for (std::size_t k = 0; k < floor.size(); k++) {
            const Node &node = floor[k];
            const double pressed = pressure(node);
            if (pressed == 0) continue;
            const double slip = u(node.x) - before(node.x), length = std::hypot(slip, onset), friction = force[k] / law_area;
            rest(node.x) += node.area * friction * slip / length;
            rest(node.y) -= node.area * pressed;
            tangent.add(node.x, node.x, node.area * friction * onset * onset / (length * length * length));
            tangent.add(node.x, node.y, -node.area * slope[k] * penalty * slip / length);
            tangent.add(node.y, node.y, node.area * penalty);
        }
    }

    const asperity_model *law;
    double law_area, lightest, penalty, onset;
    Triangulation<2> mesh;
    FESystem<2> fe;
    DoFHandler<2> dofs;
    SparsityPattern sparsity;
    SparseMatrix<double> elastic, tangent;
    Vector<double> u, before, rest;
    std::vector<Node> floor, top;
};

int main(int count, char **word) {
    asperity_params params;
    asperity_model *law = nullptr;
    char message[400];
    if (asperity_params_init(&params, sizeof params) != ASPERITY_OK || asperity_params_read(&params, word[1]) != ASPERITY_OK ||
        asperity_create(&params, &law) != ASPERITY_OK) {
        asperity_last_error(message, sizeof message);
        std::cerr << message << "\n";
        return 1;
    }
    std::vector<double> number(2);
    for (int k = 2; k < count; k++) number.push_back(std::atof(word[k]));
    std::cout.precision(17);
    try {
        Block block(law, number[2], number[3], number[4], Point<2>(number[5], number[6]), {unsigned(number[7]), unsigned(number[8])}, number[9],
                    number[10]);
        for (int k = 11; k + 1 < count; k += 2) {
            block.push(number[k], number[k + 1]);
            block.print();
        }
    } catch (const std::runtime_error &error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    asperity_free(law);
}
