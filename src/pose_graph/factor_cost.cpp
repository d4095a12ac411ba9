// SPDX-License-Identifier: MIT
#include "revisit_slam/pose_graph/factor_cost.h"

#include "revisit_slam/pose_graph/information_root.h"
#include "revisit_slam/pose_graph/pose_block.h"

namespace revisit_slam {
namespace {

/// The derivative by a right perturbation of a pose block -> by the block's entries.
template <int rows>
void writeBlockJacobian(const Eigen::Matrix<double, rows, 6>& by_perturbation, const double* block,
                        double* jacobian) {
  Eigen::Matrix<double, 6, 7, Eigen::RowMajor> minus;
  PoseChart::minusJacobian(block, minus.data());
  Eigen::Map<Eigen::Matrix<double, rows, 7, Eigen::RowMajor>> J(jacobian);
  J.template leftCols<4>().noalias() =
      by_perturbation.template rightCols<3>() * minus.template bottomLeftCorner<3, 4>();
  J.template rightCols<3>().noalias() =
      by_perturbation.template leftCols<3>() * minus.template topRightCorner<3, 3>();
}

template <typename Measured>
class FactorCost : public ceres::CostFunction {
 public:
  explicit FactorCost(const Measured& measured)
      : measured_(measured), root_(informationRoot(measured.information)) {
    set_num_residuals(Shape::kRows);
    mutable_parameter_block_sizes()->assign(Shape::kNodes, PoseChart::kAmbient);
  }

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    typename Shape::Poses T_map_node;
    for (std::size_t k = 0; k < Shape::kNodes; ++k) T_map_node[k] = poseOf(blocks[k]);
    Eigen::Map<typename Shape::Error> residual(residuals);
    if (jacobians == nullptr) {
      residual.noalias() = root_ * measured_.error(T_map_node);
      return true;
    }
    const auto linear = measured_.linearized(T_map_node, root_);
    residual = linear.residual;
    for (std::size_t k = 0; k < Shape::kNodes; ++k)
      if (jacobians[k] != nullptr)
        writeBlockJacobian<Shape::kRows>(linear.jacobians[k], blocks[k], jacobians[k]);
    return true;
  }

 private:
  using Shape = typename Measured::Shape;

  const Measured& measured_;
  typename Shape::Information root_;  ///< U
};

}  // namespace

std::unique_ptr<ceres::CostFunction> makeCost(const Factor& factor) {
  return std::visit(
      [](const auto& measured) -> std::unique_ptr<ceres::CostFunction> {
        using Measured = std::decay_t<decltype(measured)>;
        return std::make_unique<FactorCost<Measured>>(measured);
      },
      factor.measurement);
}

}  // namespace revisit_slam
