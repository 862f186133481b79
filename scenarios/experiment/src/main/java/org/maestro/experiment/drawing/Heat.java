package org.maestro.experiment.drawing;

import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.annotations.XYTextAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.LookupPaintScale;
import org.jfree.chart.renderer.xy.XYBlockRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.PaintScaleLegend;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.DefaultXYDataset;
import org.jfree.data.xy.DefaultXYZDataset;
import org.maestro.ontology.floor.Point2;

/**
 * A heat map of the time that somebody was in each square of a floor: a bivariate histogram,
 * colours by logarithm.
 */
public final class Heat {
  private static final double SQUARE_METRES = 0.1;
  private static final double LEAST_SECONDS = 0.1;
  private static final int STEPS = 60;
  private static final int MARGINS_ACROSS = 330;
  private static final int MARGINS_UP = 260;

  /** From dark to light, as in Matplotlib's viridis. */
  private static final int[] VIRIDIS = {
    0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725
  };

  private Heat() {}

  /**
   * @param width of the floor, from 0; metres
   * @param places where somebody was, at even times
   * @param seconds between two of them
   * @param marks named places that are marked
   * @param greatest seconds at the colours' upper end, so that figures can be compared
   */
  public static BufferedImage draw(
      String title,
      double width,
      double depth,
      List<Point2> places,
      double seconds,
      Map<String, Point2> marks,
      double greatest) {
    NumberAxis across = Style.axis("x (m)");
    across.setRange(0, width);
    NumberAxis up = Style.axis("y (m)");
    up.setRange(0, depth);
    up.setTickUnit(new NumberTickUnit(1));
    across.setTickUnit(new NumberTickUnit(1));
    XYPlot plot = Style.plot(across, up);
    plot.setBackgroundPaint(new Color(0xF2, 0xF2, 0xF2));
    LookupPaintScale scale = scale(Math.max(greatest, 10 * LEAST_SECONDS));
    XYBlockRenderer blocks = new XYBlockRenderer();
    blocks.setBlockWidth(SQUARE_METRES);
    blocks.setBlockHeight(SQUARE_METRES);
    blocks.setPaintScale(scale);
    plot.setDataset(1, squares(width, depth, places, seconds));
    plot.setRenderer(1, blocks);
    mark(plot, marks);
    JFreeChart chart = Style.chart(title, plot);
    chart.removeLegend();
    chart.addSubtitle(legend(scale));
    int height = (int) Math.round((Style.WIDTH - MARGINS_ACROSS) * depth / width) + MARGINS_UP;
    return Style.image(chart, Style.WIDTH, height);
  }

  /** The longest time in one square; seconds. */
  public static double greatest(double width, double depth, List<Point2> places, double seconds) {
    double greatest = 0;
    for (double[] column : counts(width, depth, places)) {
      for (double count : column) {
        greatest = Math.max(greatest, count * seconds);
      }
    }
    return greatest;
  }

  private static double[][] counts(double width, double depth, List<Point2> places) {
    double[][] counts =
        new double[(int) Math.ceil(width / SQUARE_METRES)][(int) Math.ceil(depth / SQUARE_METRES)];
    for (Point2 place : places) {
      int column = (int) Math.floor(place.x() / SQUARE_METRES);
      int row = (int) Math.floor(place.y() / SQUARE_METRES);
      if (column >= 0 && column < counts.length && row >= 0 && row < counts[0].length) {
        counts[column][row]++;
      }
    }
    return counts;
  }

  private static DefaultXYZDataset squares(
      double width, double depth, List<Point2> places, double seconds) {
    double[][] counts = counts(width, depth, places);
    List<double[]> visited = new ArrayList<>();
    for (int column = 0; column < counts.length; column++) {
      for (int row = 0; row < counts[0].length; row++) {
        if (counts[column][row] > 0) {
          visited.add(
              new double[] {
                (column + 0.5) * SQUARE_METRES,
                (row + 0.5) * SQUARE_METRES,
                Math.log10(Math.max(LEAST_SECONDS, counts[column][row] * seconds))
              });
        }
      }
    }
    double[][] data = new double[3][visited.size()];
    for (int i = 0; i < visited.size(); i++) {
      for (int row = 0; row < 3; row++) {
        data[row][i] = visited.get(i)[row];
      }
    }
    DefaultXYZDataset squares = new DefaultXYZDataset();
    squares.addSeries("seconds", data);
    return squares;
  }

  /** Of decimal logarithms of seconds. */
  private static LookupPaintScale scale(double greatest) {
    double least = Math.log10(LEAST_SECONDS);
    double most = Math.log10(greatest);
    LookupPaintScale scale = new LookupPaintScale(least, most, Color.WHITE);
    for (int i = 0; i < STEPS; i++) {
      double from = least + (most - least) * i / STEPS;
      scale.add(i == 0 ? least : from, viridis((double) i / (STEPS - 1)));
    }
    return scale;
  }

  private static Color viridis(double share) {
    double place = share * (VIRIDIS.length - 1);
    int below = Math.min(VIRIDIS.length - 2, (int) place);
    Color from = new Color(VIRIDIS[below]);
    Color to = new Color(VIRIDIS[below + 1]);
    double part = place - below;
    return new Color(
        (int) Math.round(from.getRed() + part * (to.getRed() - from.getRed())),
        (int) Math.round(from.getGreen() + part * (to.getGreen() - from.getGreen())),
        (int) Math.round(from.getBlue() + part * (to.getBlue() - from.getBlue())));
  }

  private static PaintScaleLegend legend(LookupPaintScale scale) {
    NumberAxis axis = new Decades("time in a square of 0.1 m (s)");
    Style.ink(axis);
    axis.setRange(scale.getLowerBound(), scale.getUpperBound());
    PaintScaleLegend legend = new PaintScaleLegend(scale, axis);
    legend.setPosition(RectangleEdge.RIGHT);
    legend.setStripWidth(34);
    legend.setSubdivisionCount(4000);
    legend.setMargin(new RectangleInsets(20, 16, 60, 10));
    legend.setBackgroundPaint(Color.WHITE);
    return legend;
  }

  private static void mark(XYPlot plot, Map<String, Point2> marks) {
    DefaultXYDataset data = new DefaultXYDataset();
    XYLineAndShapeRenderer rings = new XYLineAndShapeRenderer(false, true);
    marks.forEach(
        (name, place) -> {
          data.addSeries(name, new double[][] {{place.x()}, {place.y()}});
          int series = data.getSeriesCount() - 1;
          rings.setSeriesShape(series, new Ellipse2D.Double(-11, -11, 22, 22));
          rings.setSeriesShapesFilled(series, false);
          rings.setSeriesOutlinePaint(series, Ink.RED.color());
          rings.setSeriesOutlineStroke(series, Ink.solid(5));
          XYTextAnnotation label = new XYTextAnnotation(name, place.x(), place.y() + 0.12);
          label.setFont(Style.TICK);
          label.setPaint(Ink.RED.color());
          label.setTextAnchor(TextAnchor.BOTTOM_CENTER);
          label.setBackgroundPaint(new Color(255, 255, 255, 200));
          plot.addAnnotation(label);
        });
    rings.setUseOutlinePaint(true);
    rings.setDrawOutlines(true);
    plot.setDataset(0, data);
    plot.setRenderer(0, rings);
  }
}
