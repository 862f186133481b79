package org.maestro.experiment.drawing;

import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.annotations.XYShapeAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.LookupPaintScale;
import org.jfree.chart.renderer.xy.XYBlockRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.data.xy.DefaultXYDataset;
import org.jfree.data.xy.DefaultXYZDataset;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;
import org.maestro.ontology.floor.Point2;

/** A square floor with how strong something is at each place, what stands on it, and a way. */
public final class Terrain {
  private static final double SQUARE_METRES = 0.25;
  private static final int STEPS = 20;
  private static final int MARGINS = 250;

  /** What is round and stands on the floor; metres. */
  public record Body(Point2 middle, double radius) {}

  private Terrain() {}

  /**
   * @param side of the floor, from 0; metres
   * @param strength at a place
   * @param greatest strength
   * @param quantity the legend's word for what is darker where it is stronger
   */
  public static BufferedImage draw(
      String title,
      double side,
      ToDoubleFunction<Point2> strength,
      double greatest,
      String quantity,
      List<Body> bodies,
      List<Point2> way) {
    XYPlot plot = Style.plot(axis("x (m)", side), axis("y (m)", side));
    plot.setDomainGridlinesVisible(false);
    plot.setRangeGridlinesVisible(false);
    plot.setDataset(0, squares(side, strength));
    plot.setRenderer(0, blocks(greatest));
    plot.setDataset(1, ends(way));
    XYLineAndShapeRenderer dots = new XYLineAndShapeRenderer(false, true);
    dots.setSeriesShape(0, new Ellipse2D.Double(-12, -12, 24, 24));
    dots.setSeriesPaint(0, Color.WHITE);
    dots.setSeriesOutlinePaint(0, Ink.RED.color());
    dots.setSeriesOutlineStroke(0, Ink.solid(5));
    dots.setUseOutlinePaint(true);
    dots.setSeriesShape(1, new Ellipse2D.Double(-12, -12, 24, 24));
    dots.setSeriesPaint(1, Ink.RED.color());
    dots.setSeriesOutlinePaint(1, Ink.RED.color());
    plot.setRenderer(1, dots);
    plot.setDataset(2, line(way));
    XYLineAndShapeRenderer line = new XYLineAndShapeRenderer(true, false);
    line.setSeriesPaint(0, Ink.RED.color());
    line.setSeriesStroke(0, Ink.solid(4));
    plot.setRenderer(2, line);
    plot.setDatasetRenderingOrder(DatasetRenderingOrder.FORWARD);
    bodies.forEach(body -> plot.addAnnotation(disc(body)));
    LegendItemCollection legend = new LegendItemCollection();
    legend.add(Style.patch(quantity, shade(0.7)));
    legend.add(Style.patch("what stands there", Ink.DARK_GREY.color()));
    legend.add(Style.stroke("the robot's way, from the ring to the dot", Ink.RED));
    plot.setFixedLegendItems(legend);
    JFreeChart chart = Style.chart(title, plot);
    return Style.image(chart, Style.WIDTH, Style.WIDTH + MARGINS / 2);
  }

  private static NumberAxis axis(String label, double side) {
    NumberAxis axis = Style.axis(label);
    axis.setRange(0, side);
    axis.setTickUnit(new NumberTickUnit(2));
    return axis;
  }

  private static XYShapeAnnotation disc(Body body) {
    return new XYShapeAnnotation(
        new Ellipse2D.Double(
            body.middle().x() - body.radius(),
            body.middle().y() - body.radius(),
            2 * body.radius(),
            2 * body.radius()),
        Ink.solid(1),
        Ink.DARK_GREY.color(),
        Ink.DARK_GREY.color());
  }

  private static XYBlockRenderer blocks(double greatest) {
    LookupPaintScale scale = new LookupPaintScale(0, greatest, Color.WHITE);
    for (int i = 0; i < STEPS; i++) {
      scale.add(greatest * i / STEPS, shade((double) i / STEPS));
    }
    XYBlockRenderer blocks = new XYBlockRenderer();
    blocks.setBlockWidth(SQUARE_METRES);
    blocks.setBlockHeight(SQUARE_METRES);
    blocks.setPaintScale(scale);
    return blocks;
  }

  /** From white to blue. */
  private static Color shade(double share) {
    Color most = Ink.BLUE.color();
    return new Color(
        mixed(most.getRed(), share), mixed(most.getGreen(), share), mixed(most.getBlue(), share));
  }

  private static int mixed(int most, double share) {
    return (int) Math.round(255 + share * (most - 255));
  }

  private static DefaultXYZDataset squares(double side, ToDoubleFunction<Point2> strength) {
    int count = (int) Math.ceil(side / SQUARE_METRES);
    double[][] data = new double[3][count * count];
    for (int i = 0; i < count * count; i++) {
      int column = i % count;
      int row = i / count;
      Point2 place = new Point2((column + 0.5) * SQUARE_METRES, (row + 0.5) * SQUARE_METRES);
      data[0][i] = place.x();
      data[1][i] = place.y();
      data[2][i] = strength.applyAsDouble(place);
    }
    DefaultXYZDataset squares = new DefaultXYZDataset();
    squares.addSeries("strength", data);
    return squares;
  }

  private static DefaultXYDataset ends(List<Point2> way) {
    DefaultXYDataset ends = new DefaultXYDataset();
    if (!way.isEmpty()) {
      Point2 first = way.get(0);
      Point2 last = way.get(way.size() - 1);
      ends.addSeries("first", new double[][] {{first.x()}, {first.y()}});
      ends.addSeries("last", new double[][] {{last.x()}, {last.y()}});
    }
    return ends;
  }

  /** In the order in which it was gone. */
  private static XYSeriesCollection line(List<Point2> way) {
    XYSeries line = new XYSeries("way", false, true);
    way.forEach(place -> line.add(place.x(), place.y()));
    return new XYSeriesCollection(line);
  }
}
