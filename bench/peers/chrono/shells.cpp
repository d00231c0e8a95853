// Time per element and step of the shell element 3423 of Project Chrono.
//
// The model of its unit test utest_FEA_ANCFShell_Iso with n x n elements: a square plate, one edge fixed, 50 N at a corner,
// Kelvin-Voigt damping, trapezoidal rule with steps of 1 ms, sparse LU of Eigen. The problem `chrono_shell_isotropic` of
// `ancf verify` is the same plate.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "chrono/fea/ChElementShellANCF_3423.h"
#include "chrono/fea/ChMesh.h"
#include "chrono/physics/ChSystemSMC.h"
#include "chrono/solver/ChDirectSolverLS.h"
#include "chrono/timestepper/ChTimestepperHHT.h"

using namespace chrono;
using namespace chrono::fea;

namespace {

// Steps before the measured ones: the first ones have the symbolic factorisation.
constexpr int WARM_UP = 2;
constexpr double STEP = 1e-3;

using Nodes = std::vector<std::shared_ptr<ChNodeFEAxyzD>>;

double seconds() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

Nodes build(ChSystem& system, int n) {
    auto mesh = chrono_types::make_shared<ChMesh>();
    Nodes nodes;
    for (int k = 0; k < (n + 1) * (n + 1); ++k) {
        const int i = k % (n + 1), j = k / (n + 1);
        const ChVector3d place(double(i) / n, double(j) / n, 0.0);
        auto node = chrono_types::make_shared<ChNodeFEAxyzD>(place, ChVector3d(0, 0, 1));
        node->SetMass(0);
        node->SetFixed(i == 0);
        mesh->AddNode(node);
        nodes.push_back(node);
    }
    auto material = chrono_types::make_shared<ChMaterialShellANCF>(500, 2.1e8, 0.3);
    for (int k = 0; k < n * n; ++k) {
        const int first = k / n * (n + 1) + k % n;
        auto element = chrono_types::make_shared<ChElementShellANCF_3423>();
        element->SetNodes(nodes[first], nodes[first + 1], nodes[first + n + 2], nodes[first + n + 1]);
        element->SetDimensions(1.0 / n, 1.0 / n);
        element->AddLayer(0.01, 0.0, material);
        element->SetAlphaDamp(0.08);
        mesh->AddElement(element);
    }
    mesh->SetAutomaticGravity(false);
    system.Add(mesh);
    return nodes;
}

void choose_solvers(ChSystem& system) {
    auto solver = chrono_types::make_shared<ChSolverSparseLU>();
    solver->UseSparsityPatternLearner(false);
    solver->LockSparsityPattern(true);
    system.SetSolver(solver);
    system.SetTimestepperType(ChTimestepper::Type::HHT);
    auto stepper = std::static_pointer_cast<ChTimestepperHHT>(system.GetTimestepper());
    stepper->SetAlpha(0.0);
    stepper->SetMaxIters(100);
    stepper->SetAbsTolerances(1e-6);
    stepper->SetStepControl(false);
}

}  // namespace

int main(int count, char** words) {
    const int n = count > 1 ? std::atoi(words[1]) : 32;
    const int steps = count > 2 ? std::atoi(words[2]) : 20;
    ChSystemSMC system;
    system.SetGravitationalAcceleration(ChVector3d(0, 0, 0));
    system.SetNumThreads(1, 1, 1);
    const Nodes nodes = build(system, n);
    choose_solvers(system);
    auto stepper = std::static_pointer_cast<ChTimestepperHHT>(system.GetTimestepper());
    double start = 0;
    long iterations = 0, factorisations = 0;
    for (int k = 0; k < WARM_UP + steps; ++k) {
        if (k == WARM_UP) {
            start = seconds();
            iterations = factorisations = 0;
        }
        nodes.back()->SetForce(ChVector3d(0, 0, -50));
        system.DoStepDynamics(STEP);
        iterations += stepper->GetNumStepIterations();
        factorisations += stepper->GetNumStepSetupCalls();
    }
    const double time = (seconds() - start) / steps;
    std::printf("%d x %d elements: %.1f us per element and step, %.1f iterations and %.1f factorisations per step, corner at %.6f m\n",
                n, n, time * 1e6 / (n * n), double(iterations) / steps, double(factorisations) / steps,
                nodes.back()->GetPos().z());
}
