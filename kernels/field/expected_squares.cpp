#include "kernels/field/expected_squares.hpp"

namespace quarry {
namespace {

constexpr double kSizesOfACell = 4;

// Whether doubles hold a place strictly between both ends of each side.
bool can_be_halved(const Box2& box, Vec2 middle) {
  return middle.x > box.low.x && middle.x < box.high.x && middle.y > box.low.y && middle.y < box.high.y;
}

class Count {
 public:
  Count(const SizeField& field, double most, const std::function<bool(Vec2)>& inside)
      : field_(field), most_(most), inside_(inside) {}

  void add(const Box2& box) {
    if (squares_ > most_) return;
    const Vec2 middle = midpoint(box.low, box.high);
    const double size = field_.at(middle);
    if (box.longer_side() > kSizesOfACell * size && can_be_halved(box, middle)) {
      add({box.low, middle});
      add({{middle.x, box.low.y}, {box.high.x, middle.y}});
      add({{box.low.x, middle.y}, {middle.x, box.high.y}});
      add({middle, box.high});
    } else if (!inside_ || inside_(middle)) {
      squares_ += box.width() / size * (box.height() / size);
    }
  }
  [[nodiscard]] double squares() const { return squares_; }

 private:
  const SizeField& field_;
  double most_;
  const std::function<bool(Vec2)>& inside_;
  double squares_ = 0;
};

}  // namespace

double expected_squares(const SizeField& field, const Box2& box, double most,
                        const std::function<bool(Vec2)>& inside) {
  Count count(field, most, inside);
  count.add(box);
  return count.squares();
}

}  // namespace quarry
