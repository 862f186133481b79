package org.maestro.experiment.drawing;

import java.awt.Color;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.plot.DatasetRenderingOrder;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.TextAnchor;
import org.jfree.data.xy.DefaultXYDataset;

/** A quantity over time as a line, and a share of something as dots, each with an axis. */
public final class TimeChart {
  private static final double ROOM_ABOVE = 1.25;
  private static final int MOST_TICKS = 12;

  /**
   * @param points seconds and values
   */
  public record Series(String label, Ink ink, List<double[]> points) {}

  /** Something that happened at a time; seconds. */
  public record Event(double at, String label) {}

  private TimeChart() {}

  /**
   * @param quantity label of the left axis, with its unit
   * @param share label of the right axis; the dots are percent
   * @param threshold a labelled level on the left axis
   */
  public static BufferedImage draw(
      String title,
      String quantity,
      List<Series> lines,
      String share,
      Series dots,
      Bars.Level threshold,
      List<Event> events) {
    LegendItemCollection legend = new LegendItemCollection();
    XYPlot plot = plot(quantity, lines, threshold.value(), legend);
    NumberAxis right = Style.axis(share);
    right.setRange(-3, 109);
    right.setTickUnit(new NumberTickUnit(20));
    plot.setRangeAxis(1, right);
    plot.setDataset(1, data(List.of(dots)));
    plot.mapDatasetToRangeAxis(1, 1);
    XYLineAndShapeRenderer scatter = new XYLineAndShapeRenderer(false, true);
    scatter.setSeriesShape(0, new Ellipse2D.Double(-5, -5, 10, 10));
    scatter.setSeriesPaint(0, dots.ink().color());
    plot.setRenderer(1, scatter);
    legend.add(Style.dot(dots.label(), dots.ink()));
    plot.addRangeMarker(Style.line(threshold.value(), threshold.label(), threshold.ink(), true));
    for (Event event : events) {
      plot.addDomainMarker(marker(event));
    }
    plot.setDatasetRenderingOrder(DatasetRenderingOrder.REVERSE);
    plot.setFixedLegendItems(legend);
    return Style.image(Style.chart(title, plot));
  }

  /**
   * Lines alone.
   *
   * @param quantity label of the axis, with its unit
   */
  public static BufferedImage draw(
      String title, String quantity, List<Series> lines, List<Event> events) {
    LegendItemCollection legend = new LegendItemCollection();
    XYPlot plot = plot(quantity, lines, 0, legend);
    events.forEach(event -> plot.addDomainMarker(marker(event)));
    plot.setFixedLegendItems(legend);
    return Style.image(Style.chart(title, plot));
  }

  /**
   * @param least what the axis shows at least
   */
  private static XYPlot plot(
      String quantity, List<Series> lines, double least, LegendItemCollection legend) {
    NumberAxis time = Style.axis("time (s)");
    double last = lines.get(0).points().get(lines.get(0).points().size() - 1)[0];
    time.setRange(0, Math.ceil(last));
    time.setTickUnit(new NumberTickUnit(tick(last)));
    NumberAxis left = Style.axis(quantity);
    double greatest = least;
    for (Series line : lines) {
      for (double[] point : line.points()) {
        greatest = Math.max(greatest, point[1]);
      }
    }
    left.setRange(0, greatest * ROOM_ABOVE);
    XYPlot plot = Style.plot(time, left);
    plot.setDataset(0, data(lines));
    XYLineAndShapeRenderer line = new XYLineAndShapeRenderer(true, false);
    for (int i = 0; i < lines.size(); i++) {
      line.setSeriesPaint(i, lines.get(i).ink().color());
      line.setSeriesStroke(i, Ink.solid(5));
      legend.add(Style.stroke(lines.get(i).label(), lines.get(i).ink()));
    }
    plot.setRenderer(0, line);
    return plot;
  }

  /** So that a dozen of them stand below the axis at most, each a round number. */
  static double tick(double last) {
    double tick = 1;
    for (int i = 0; last / tick > MOST_TICKS; i++) {
      tick *= i % 3 == 1 ? 2.5 : 2;
    }
    return tick;
  }

  static ValueMarker marker(Event event) {
    ValueMarker marker = new ValueMarker(event.at(), Ink.GREY.color(), Ink.dashed(3));
    marker.setLabel(event.label());
    marker.setLabelFont(Style.TICK);
    marker.setLabelPaint(Ink.DARK_GREY.color());
    marker.setLabelBackgroundColor(Color.WHITE);
    marker.setLabelAnchor(RectangleAnchor.TOP_RIGHT);
    marker.setLabelTextAnchor(TextAnchor.TOP_LEFT);
    return marker;
  }

  static DefaultXYDataset data(List<Series> all) {
    DefaultXYDataset data = new DefaultXYDataset();
    for (Series series : all) {
      double[][] points = new double[2][series.points().size()];
      for (int i = 0; i < series.points().size(); i++) {
        points[0][i] = series.points().get(i)[0];
        points[1][i] = series.points().get(i)[1];
      }
      data.addSeries(series.label(), points);
    }
    return data;
  }
}
