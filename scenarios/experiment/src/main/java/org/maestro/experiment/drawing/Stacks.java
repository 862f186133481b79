package org.maestro.experiment.drawing;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.axis.AxisLocation;
import org.jfree.chart.axis.CategoryAxis;
import org.jfree.chart.axis.CategoryLabelPositions;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.labels.StandardCategoryItemLabelGenerator;
import org.jfree.chart.plot.CategoryPlot;
import org.jfree.chart.plot.PlotOrientation;
import org.jfree.chart.renderer.category.StackedBarRenderer;
import org.jfree.chart.renderer.category.StandardBarPainter;
import org.jfree.data.category.DefaultCategoryDataset;

/**
 * A stacked bar chart of the endings of runs under several conditions: a bar for each condition, a
 * piece for each ending.
 */
public final class Stacks {

  /** A way of ending. */
  public record Piece(String label, Ink ink) {}

  /**
   * @param counts one for each piece
   */
  public record Stack(String label, List<Integer> counts) {}

  private Stacks() {}

  public static BufferedImage draw(
      String title, String counted, List<Piece> pieces, List<Stack> stacks) {
    DefaultCategoryDataset data = new DefaultCategoryDataset();
    for (Stack stack : stacks) {
      for (int i = 0; i < pieces.size(); i++) {
        int count = stack.counts().get(i);
        data.addValue(count == 0 ? null : (Integer) count, pieces.get(i).label(), stack.label());
      }
    }
    StackedBarRenderer renderer = new StackedBarRenderer();
    renderer.setBarPainter(new StandardBarPainter());
    renderer.setShadowVisible(false);
    renderer.setMaximumBarWidth(0.2);
    renderer.setDefaultItemLabelGenerator(new StandardCategoryItemLabelGenerator());
    renderer.setDefaultItemLabelsVisible(true);
    renderer.setDefaultItemLabelFont(Style.LABEL);
    renderer.setDefaultItemLabelPaint(Color.WHITE);
    LegendItemCollection legend = new LegendItemCollection();
    for (int i = 0; i < pieces.size(); i++) {
      renderer.setSeriesPaint(i, pieces.get(i).ink().color());
      legend.add(Style.patch(pieces.get(i).label(), pieces.get(i).ink().color()));
    }
    CategoryAxis conditions = new CategoryAxis();
    Style.ink(conditions);
    conditions.setMaximumCategoryLabelLines(3);
    conditions.setCategoryLabelPositions(CategoryLabelPositions.STANDARD);
    NumberAxis values = Style.axis(counted);
    values.setStandardTickUnits(NumberAxis.createIntegerTickUnits());
    values.setAutoRangeIncludesZero(true);
    CategoryPlot plot = new CategoryPlot(data, conditions, values, renderer);
    plot.setOrientation(PlotOrientation.HORIZONTAL);
    plot.setRangeAxisLocation(AxisLocation.BOTTOM_OR_LEFT);
    plot.setBackgroundPaint(Color.WHITE);
    plot.setRangeGridlinePaint(new Color(0xDD, 0xDD, 0xDD));
    plot.setOutlinePaint(Ink.BLACK.color());
    plot.setFixedLegendItems(legend);
    return Style.image(Style.chart(title, plot), Style.WIDTH, 240 + 140 * stacks.size());
  }
}
