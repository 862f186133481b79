package org.maestro.bench.containers;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.Stacks;

/**
 * The processor time that a goal costs the platform's own process, part by part, with more and more
 * containers: of what there is one only, which part grows. Writes {@code growth.csv} and {@code
 * growth.png}. For one thread.
 */
public final class GrowthBench {
  /** Usually measured with. */
  public static final List<Integer> CONTAINERS = List.of(20, 50, 100, 200);

  private static final int IN_A_PROCESS = 10;
  private static final int GOALS = 200;
  private static final List<Stacks.Piece> PIECES =
      List.of(
          new Stacks.Piece(CpuByPart.BROKER, Ink.BLUE),
          new Stacks.Piece(CpuByPart.CENTRE, Ink.RED),
          new Stacks.Piece(CpuByPart.PAGES, Ink.GREEN),
          new Stacks.Piece(CpuByPart.STORE, Ink.PURPLE),
          new Stacks.Piece(CpuByPart.CLOCK, Ink.DARK_GREY),
          new Stacks.Piece(CpuByPart.REST, Ink.ORANGE));

  private final Path directory;
  private final List<Integer> sizes;
  private final Consumer<String> progress;

  /**
   * @param directory for the figures; made if need be
   * @param sizes with how many containers each
   */
  public GrowthBench(Path directory, List<Integer> sizes, Consumer<String> progress) {
    this.directory = directory;
    this.sizes = List.copyOf(sizes);
    this.progress = progress;
  }

  /**
   * @throws UncheckedIOException when the directory cannot be written to
   */
  public BenchReport run() {
    List<BenchReport.Row> all = new ArrayList<>();
    List<String> lines = new ArrayList<>(List.of("containers,figure,value,unit"));
    List<Stacks.Stack> stacks = new ArrayList<>();
    for (int containers : sizes) {
      int processes = Math.max(2, containers / IN_A_PROCESS);
      List<BenchReport.Row> rows =
          new ContainersBench(processes, containers, GOALS, 1, progress).run().rows();
      for (BenchReport.Row row : rows) {
        lines.add(
            String.format(
                Locale.ROOT, "%d,\"%s\",%.3f,%s", containers, row.name(), row.value(), row.unit()));
        all.add(
            BenchReport.Row.of(containers + " containers: " + row.name(), row.value(), row.unit()));
      }
      stacks.add(new Stacks.Stack(containers + " containers", millis(rows)));
    }
    write(lines, stacks);
    return new BenchReport("growth", BenchReport.thisMachine(), all);
  }

  private static List<Integer> millis(List<BenchReport.Row> rows) {
    return PIECES.stream()
        .map(
            piece ->
                rows.stream()
                    .filter(row -> row.name().equals(ContainersBench.PROCESSOR + piece.label()))
                    .mapToInt(row -> (int) Math.round(row.value()))
                    .sum())
        .toList();
  }

  private void write(List<String> lines, List<Stacks.Stack> stacks) {
    try {
      Files.createDirectories(directory);
      Files.write(directory.resolve("growth.csv"), lines);
    } catch (IOException e) {
      throw new UncheckedIOException("The figures cannot be written to " + directory + ".", e);
    }
    Figure.of(
            "growth",
            "What a goal costs the platform's own process.",
            Stacks.draw(
                "What a goal costs the platform's own process",
                "processor time of a goal (ms)",
                PIECES,
                stacks))
        .write(directory);
  }
}
