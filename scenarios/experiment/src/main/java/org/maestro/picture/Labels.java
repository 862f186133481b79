package org.maestro.picture;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.TextLayout;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Names beside their symbols, each where it covers least; those asked for first choose first, and
 * take the earlier of equally good places.
 */
final class Labels {
  private static final double GAP = 6;
  private static final double FURTHER = 30;
  private static final double LINE_WEIGHT = 40;
  private static final double DISTANCE_WEIGHT = 4;
  private static final double OUTSIDE_WEIGHT = 1000;

  private record Label(String text, Point2D at, double radius, Font font) {}

  private final Rectangle2D bounds;
  private final List<Label> labels = new ArrayList<>();
  private final List<Rectangle2D> taken = new ArrayList<>();
  private final List<Line2D> lines = new ArrayList<>();

  /**
   * @param bounds that no label leaves
   */
  Labels(Rectangle2D bounds) {
    this.bounds = bounds;
  }

  /**
   * A label for the symbol there.
   *
   * @param radius of the symbol, which no label is to cover; pixels
   */
  void add(String text, Point2D symbol, double radius, Font font) {
    labels.add(new Label(text, symbol, radius, font));
    taken.add(
        new Rectangle2D.Double(
            symbol.getX() - radius, symbol.getY() - radius, 2 * radius, 2 * radius));
  }

  /** Labels cover the line only where there is no better place. */
  void avoid(Line2D line) {
    lines.add(line);
  }

  void draw(Graphics2D canvas) {
    for (Label label : labels) {
      Rectangle2D box = place(canvas, label);
      taken.add(box);
      Texts.draw(canvas, label.text(), box.getX(), box.getMaxY() - 6, label.font(), Palette.INK);
    }
  }

  private Rectangle2D place(Graphics2D canvas, Label label) {
    double width =
        new TextLayout(label.text(), label.font(), canvas.getFontRenderContext()).getAdvance();
    double height = label.font().getSize() + 4.0;
    Rectangle2D best = null;
    double least = Double.POSITIVE_INFINITY;
    for (double further = 0; further <= 3 * FURTHER; further += FURTHER) {
      for (Rectangle2D box : around(label, width, height, further)) {
        double cost = cost(box) + further * DISTANCE_WEIGHT;
        if (cost < least) {
          least = cost;
          best = box;
        }
      }
    }
    return Objects.requireNonNull(best);
  }

  private static List<Rectangle2D> around(
      Label label, double width, double height, double further) {
    double away = label.radius() + GAP + further;
    double x = label.at().getX();
    double y = label.at().getY();
    double above = y - away - height;
    double below = y + away;
    List<Rectangle2D> boxes = new ArrayList<>();
    if (further == 0) {
      boxes.add(new Rectangle2D.Double(x + away, y - height / 2, width, height));
      boxes.add(new Rectangle2D.Double(x - away - width, y - height / 2, width, height));
    }
    for (double row : new double[] {above, below}) {
      boxes.add(new Rectangle2D.Double(x - width / 2, row, width, height));
      boxes.add(new Rectangle2D.Double(x - label.radius(), row, width, height));
      boxes.add(new Rectangle2D.Double(x + label.radius() - width, row, width, height));
    }
    return boxes;
  }

  private double cost(Rectangle2D box) {
    double cost = bounds.contains(box) ? 0 : OUTSIDE_WEIGHT * box.getHeight();
    for (Rectangle2D other : taken) {
      Rectangle2D shared = box.createIntersection(other);
      if (!shared.isEmpty()) {
        cost += OUTSIDE_WEIGHT + shared.getWidth() * shared.getHeight();
      }
    }
    return cost + LINE_WEIGHT * lines.stream().filter(line -> line.intersects(box)).count();
  }
}
