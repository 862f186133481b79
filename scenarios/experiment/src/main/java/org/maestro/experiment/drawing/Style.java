package org.maestro.experiment.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Paint;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItem;
import org.jfree.chart.axis.Axis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.block.BlockBorder;
import org.jfree.chart.plot.Plot;
import org.jfree.chart.plot.ValueMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleAnchor;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.TextAnchor;

/** The common style of all figures. */
final class Style {
  static final int WIDTH = 1600;
  static final int HEIGHT = 900;
  static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 34);
  static final Font LABEL = new Font(Font.SANS_SERIF, Font.PLAIN, 29);
  static final Font TICK = new Font(Font.SANS_SERIF, Font.PLAIN, 26);
  private static final Color GRID = new Color(0xDD, 0xDD, 0xDD);

  private Style() {}

  static NumberAxis axis(String label) {
    NumberAxis axis = new NumberAxis(label);
    axis.setAutoRangeIncludesZero(false);
    ink(axis);
    return axis;
  }

  static void ink(Axis axis) {
    axis.setLabelFont(LABEL);
    axis.setTickLabelFont(TICK);
    axis.setLabelPaint(Ink.BLACK.color());
    axis.setTickLabelPaint(Ink.BLACK.color());
    axis.setAxisLinePaint(Ink.BLACK.color());
    axis.setTickMarkPaint(Ink.BLACK.color());
    axis.setLabelInsets(new RectangleInsets(6, 6, 6, 6));
  }

  static XYPlot plot(ValueAxis across, NumberAxis up) {
    XYPlot plot = new XYPlot(null, across, up, null);
    plot.setBackgroundPaint(Color.WHITE);
    plot.setDomainGridlinePaint(GRID);
    plot.setRangeGridlinePaint(GRID);
    plot.setDomainGridlineStroke(new BasicStroke(1.5f));
    plot.setRangeGridlineStroke(new BasicStroke(1.5f));
    plot.setOutlinePaint(Ink.BLACK.color());
    plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
    plot.setInsets(new RectangleInsets(8, 8, 8, 24));
    return plot;
  }

  static ValueMarker line(double value, Ink ink) {
    return new ValueMarker(value, ink.color(), Ink.dashed(5));
  }

  /** A line with its label at the left end, below the line or above it. */
  static ValueMarker line(double value, String label, Ink ink, boolean above) {
    ValueMarker marker = line(value, ink);
    marker.setLabel(label);
    marker.setLabelFont(TICK);
    marker.setLabelPaint(ink.color());
    marker.setLabelBackgroundColor(new Color(255, 255, 255, 215));
    marker.setLabelAnchor(above ? RectangleAnchor.TOP_LEFT : RectangleAnchor.BOTTOM_LEFT);
    marker.setLabelTextAnchor(above ? TextAnchor.BOTTOM_LEFT : TextAnchor.TOP_LEFT);
    marker.setLabelOffset(new RectangleInsets(6, 12, 6, 12));
    return marker;
  }

  static LegendItem stroke(String label, Ink ink) {
    LegendItem item =
        new LegendItem(
            label, null, null, null, new Line2D.Double(-28, 0, 28, 0), Ink.solid(5), ink.color());
    item.setLabelFont(TICK);
    return item;
  }

  static LegendItem dot(String label, Ink ink) {
    LegendItem item =
        new LegendItem(label, null, null, null, new Ellipse2D.Double(-8, -8, 16, 16), ink.color());
    item.setLabelFont(TICK);
    return item;
  }

  static LegendItem dash(String label, Ink ink) {
    LegendItem item =
        new LegendItem(
            label, null, null, null, new Line2D.Double(-28, 0, 28, 0), Ink.dashed(5), ink.color());
    item.setLabelFont(TICK);
    return item;
  }

  static LegendItem patch(String label, Paint paint) {
    LegendItem item =
        new LegendItem(label, null, null, null, new Rectangle2D.Double(-15, -11, 30, 22), paint);
    item.setLabelFont(TICK);
    return item;
  }

  static JFreeChart chart(String title, Plot plot) {
    JFreeChart chart = new JFreeChart(title, TITLE, plot, false);
    chart.setBackgroundPaint(Color.WHITE);
    chart.setTextAntiAlias(true);
    chart.setPadding(new RectangleInsets(14, 10, 10, 14));
    chart.getTitle().setPaint(Ink.BLACK.color());
    LegendTitle legend = new LegendTitle(plot);
    legend.setItemFont(TICK);
    legend.setPosition(RectangleEdge.BOTTOM);
    legend.setFrame(BlockBorder.NONE);
    legend.setItemLabelPadding(new RectangleInsets(4, 4, 4, 26));
    chart.addLegend(legend);
    return chart;
  }

  static BufferedImage image(JFreeChart chart) {
    return image(chart, WIDTH, HEIGHT);
  }

  static BufferedImage image(JFreeChart chart, int width, int height) {
    return chart.createBufferedImage(width, height, BufferedImage.TYPE_INT_RGB, null);
  }
}
