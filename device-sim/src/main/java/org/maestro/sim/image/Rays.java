package org.maestro.sim.image;

import java.util.List;
import org.maestro.hal.sight.Paint;
import org.maestro.hal.sight.Vector;

/** Finds what a ray meets first, and the light that it throws back. For one picture. */
final class Rays {

  private static final Paint FLOOR = new Paint(0.42, 0.40, 0.37);
  private static final Paint WALL = new Paint(0.72, 0.71, 0.68);
  private static final Paint OUTSIDE = new Paint(0.03, 0.03, 0.03);

  /** Shares of the light upon a horizontal surface that fall upon upright ones; assumed. */
  private static final double UPON_SIDES = 0.5;

  private static final double UPON_WALLS = 0.6;
  private static final double SIDE_DIFFERENCE = 0.15;

  /** Seams of the floor, so that one sees that it is one; metres. */
  private static final double TILE = 0.5;

  private static final double SEAM = 0.008;
  private static final double NEAR = 1e-9;

  private final Stage stage;
  private final Vector from;

  private double best;
  private Paint colour = OUTSIDE;
  private double lux;

  Rays(Stage stage, Vector from) {
    this.stage = stage;
    this.from = from;
  }

  /** Share thrown back times lux, for each colour. */
  Paint light(Vector direction) {
    best = Double.POSITIVE_INFINITY;
    colour = OUTSIDE;
    lux = 0;
    floor(direction);
    walls(direction, stage.walls());
    for (Solid solid : stage.solids()) {
      switch (solid.shape()) {
        case BOX -> box(solid, direction);
        case DRUM -> drum(solid, direction);
        case BALL -> ball(solid, direction);
      }
    }
    return colour.times(lux);
  }

  private void meet(double way, Paint surface, double light) {
    best = way;
    colour = surface;
    lux = light;
  }

  private void floor(Vector direction) {
    if (direction.z() >= 0) {
      return;
    }
    double way = -from.z() / direction.z();
    double x = from.x() + way * direction.x();
    double y = from.y() + way * direction.y();
    boolean seam = fromSeam(x) < SEAM || fromSeam(y) < SEAM;
    meet(way, seam ? FLOOR.times(0.8) : FLOOR, stage.floor().lux(x, y));
  }

  private static double fromSeam(double along) {
    return Math.abs(along / TILE - Math.rint(along / TILE)) * TILE;
  }

  private void walls(Vector direction, List<Wall> walls) {
    for (Wall wall : walls) {
      double alongX = wall.toX() - wall.fromX();
      double alongY = wall.toY() - wall.fromY();
      double cross = direction.x() * alongY - direction.y() * alongX;
      if (Math.abs(cross) < NEAR) {
        continue;
      }
      double toX = wall.fromX() - from.x();
      double toY = wall.fromY() - from.y();
      double way = (toX * alongY - toY * alongX) / cross;
      double share = (toX * direction.y() - toY * direction.x()) / cross;
      double height = from.z() + way * direction.z();
      if (way > NEAR && way < best && share >= 0 && share <= 1 && height <= wall.height()) {
        // the light of the room from which it is seen, a little before the wall
        double x = from.x() + (way - 0.05) * direction.x();
        double y = from.y() + (way - 0.05) * direction.y();
        meet(way, WALL, UPON_WALLS * stage.floor().lux(x, y));
      }
    }
  }

  private void box(Solid box, Vector direction) {
    double cos = Math.cos(box.heading());
    double sin = Math.sin(box.heading());
    double[] start = {
      cos * (from.x() - box.x()) + sin * (from.y() - box.y()),
      cos * (from.y() - box.y()) - sin * (from.x() - box.x()),
      from.z()
    };
    double[] along = {
      cos * direction.x() + sin * direction.y(),
      cos * direction.y() - sin * direction.x(),
      direction.z()
    };
    double[] low = {-box.halfLength(), -box.halfWidth(), box.bottom()};
    double[] high = {box.halfLength(), box.halfWidth(), box.top()};
    double enter = 0;
    double leave = best;
    int side = 0;
    for (int axis = 0; axis < 3; axis++) {
      if (Math.abs(along[axis]) < NEAR) {
        if (start[axis] < low[axis] || start[axis] > high[axis]) {
          return;
        }
        continue;
      }
      double first = (low[axis] - start[axis]) / along[axis];
      double second = (high[axis] - start[axis]) / along[axis];
      if (Math.min(first, second) > enter) {
        enter = Math.min(first, second);
        side = axis;
      }
      leave = Math.min(leave, Math.max(first, second));
    }
    if (enter > NEAR && enter < leave) {
      meet(enter, box.colour(), box.lux() * facing(side));
    }
  }

  private static double facing(int axis) {
    return switch (axis) {
      case 0 -> UPON_SIDES - SIDE_DIFFERENCE;
      case 1 -> UPON_SIDES + SIDE_DIFFERENCE;
      default -> 1;
    };
  }

  private void drum(Solid drum, Vector direction) {
    if (direction.z() < 0) {
      double way = (drum.top() - from.z()) / direction.z();
      double x = from.x() + way * direction.x() - drum.x();
      double y = from.y() + way * direction.y() - drum.y();
      if (way > NEAR && way < best && Math.hypot(x, y) <= drum.halfLength()) {
        meet(way, drum.colour(), drum.lux());
      }
    }
    double x = from.x() - drum.x();
    double y = from.y() - drum.y();
    double a = direction.x() * direction.x() + direction.y() * direction.y();
    double b = x * direction.x() + y * direction.y();
    double c = x * x + y * y - drum.halfLength() * drum.halfLength();
    double root = b * b - a * c;
    if (a < NEAR || root < 0) {
      return;
    }
    double way = (-b - Math.sqrt(root)) / a;
    double height = from.z() + way * direction.z();
    if (way > NEAR && way < best && height >= drum.bottom() && height <= drum.top()) {
      double normal = (x + way * direction.x()) / drum.halfLength();
      meet(way, drum.colour(), drum.lux() * (UPON_SIDES + SIDE_DIFFERENCE * normal));
    }
  }

  private void ball(Solid ball, Vector direction) {
    double radius = ball.halfLength();
    double x = from.x() - ball.x();
    double y = from.y() - ball.y();
    double z = from.z() - ball.bottom() - radius;
    double a =
        direction.x() * direction.x()
            + direction.y() * direction.y()
            + direction.z() * direction.z();
    double b = x * direction.x() + y * direction.y() + z * direction.z();
    double root = b * b - a * (x * x + y * y + z * z - radius * radius);
    if (root < 0) {
      return;
    }
    double way = (-b - Math.sqrt(root)) / a;
    if (way > NEAR && way < best) {
      double up = (z + way * direction.z()) / radius;
      meet(way, ball.colour(), ball.lux() * (UPON_SIDES + (1 - UPON_SIDES) * up));
    }
  }
}
