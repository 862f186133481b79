package org.maestro.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** Title and scale bar above; below what the symbols mean, of those that are in the picture. */
final class Legend {
  private static final int COLUMN = 380;
  private static final int ROW = 48;

  /** Height of the scale bar, beside the title. */
  private static final double BAR = 48;

  /**
   * The symbols that a picture may show and their meanings, in the order in which they are
   * explained.
   */
  enum Entry {
    CAMERA("camera and what it sees", Legend::field),
    LAMP("lamp, filled as lit", (canvas, at) -> Symbols.lamp(canvas, at, 0.75)),
    SENSOR("light sensor", Symbols::sensor),
    FLOOR("floor: dark to bright", Legend::floor),
    ROBOT("robot, its way, its start", Legend::way),
    PERSON("person", Symbols::person),
    THING("thing, in its colour", Legend::thing),
    WINDOW("window", (canvas, at) -> Openings.glass(canvas, beside(at, -28), beside(at, 28))),
    SHUTTER("window, shutter", Legend::window);

    private final String meaning;

    /** Draws, and keeps nothing. */
    @SuppressWarnings("ImmutableEnumChecker")
    private final Symbol symbol;

    Entry(String meaning, Symbol symbol) {
      this.meaning = meaning;
      this.symbol = symbol;
    }
  }

  private interface Symbol {
    void draw(Graphics2D canvas, Point2D at);
  }

  private final Scale scale;
  private final Set<Entry> shown = EnumSet.noneOf(Entry.class);
  private int place;

  Legend(Scale scale) {
    this.scale = scale;
  }

  /** The picture has one of these. */
  void explain(Entry entry) {
    shown.add(entry);
  }

  void draw(Graphics2D canvas, String title) {
    String capital = title.substring(0, 1).toUpperCase(Locale.ROOT) + title.substring(1);
    Texts.draw(canvas, capital + ", from above", Scale.MARGIN, 58, Texts.TITLE, Palette.INK);
    if (shown.contains(Entry.SHUTTER)) {
      shown.remove(Entry.WINDOW);
    }
    shown.forEach(entry -> entry(canvas, entry));
    bar(canvas);
  }

  private void entry(Graphics2D canvas, Entry entry) {
    int column = place % 4;
    int row = place / 4;
    double x = Scale.MARGIN + 30 + column * (double) COLUMN;
    double y = scale.heightPixels() - Scale.LEGEND + 70 + row * (double) ROW;
    Point2D at = new Point2D.Double(x, y);
    entry.symbol.draw(canvas, at);
    Texts.draw(canvas, entry.meaning, x + 42, y + 9, Texts.SMALL, Palette.INK);
    place++;
  }

  private static void field(Graphics2D canvas, Point2D at) {
    Color color = Palette.CAMERA;
    canvas.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), 56));
    canvas.fill(new Rectangle2D.Double(at.getX() - 28, at.getY() - 18, 56, 36));
    canvas.setColor(color);
    canvas.setStroke(new BasicStroke(2.5f));
    canvas.draw(new Rectangle2D.Double(at.getX() - 28, at.getY() - 18, 56, 36));
    Symbols.camera(canvas, at);
  }

  private static void thing(Graphics2D canvas, Point2D at) {
    Symbols.thing(canvas, at, Color.LIGHT_GRAY);
  }

  private static void window(Graphics2D canvas, Point2D at) {
    Openings.glass(canvas, beside(at, -28), beside(at, 28));
    Openings.shutter(canvas, beside(at, 4), beside(at, 28));
  }

  private static Point2D beside(Point2D at, double pixels) {
    return new Point2D.Double(at.getX() + pixels, at.getY());
  }

  private static void floor(Graphics2D canvas, Point2D at) {
    for (int step = 0; step < 4; step++) {
      canvas.setColor(Palette.floor(step / 3.0));
      canvas.fill(new Rectangle2D.Double(at.getX() - 30 + 15 * step, at.getY() - 14, 15, 28));
    }
  }

  private static void way(Graphics2D canvas, Point2D at) {
    Way.draw(
        canvas,
        List.of(
            new Point2D.Double(at.getX() - 38, at.getY()),
            new Point2D.Double(at.getX() + 12, at.getY())));
    Symbols.robot(canvas, new Point2D.Double(at.getX() + 12, at.getY()));
  }

  private void bar(Graphics2D canvas) {
    double length = scale.pixels(1);
    double x = scale.width() - Scale.MARGIN - length;
    double y = BAR;
    canvas.setColor(Palette.INK);
    canvas.setStroke(new BasicStroke(4));
    canvas.draw(new Line2D.Double(x, y, x + length, y));
    canvas.draw(new Line2D.Double(x, y - 9, x, y + 9));
    canvas.draw(new Line2D.Double(x + length, y - 9, x + length, y + 9));
    Texts.draw(canvas, "1 m", x - 62, y + 9, Texts.SMALL, Palette.INK);
  }
}
