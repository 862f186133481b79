package org.maestro.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.maestro.assembly.SiteException;

/**
 * The memory that this process has after so many goals.
 *
 * @param heapMiB live: after all garbage was collected
 * @param committedMiB of the heap, live or free
 * @param programMiB classes, and the code that is compiled from them again and again until no part
 *     of it is called more often than before
 * @param residentMiB of the whole process, as the system counts it
 */
public record MemorySample(
    int goals, double heapMiB, double committedMiB, double programMiB, double residentMiB) {
  private static final double MIB = 1 << 20;
  private static final Path STATUS = Path.of("/proc/self/status");
  private static final String RESIDENT = "VmRSS:";

  public static MemorySample take(int goals) {
    System.gc();
    MemoryUsage heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage();
    return new MemorySample(
        goals, heap.getUsed() / MIB, heap.getCommitted() / MIB, program(), resident());
  }

  private static double program() {
    return ManagementFactory.getMemoryPoolMXBeans().stream()
            .filter(pool -> pool.getType() == MemoryType.NON_HEAP)
            .mapToLong(pool -> pool.getUsage().getCommitted())
            .sum()
        / MIB;
  }

  private static double resident() {
    try {
      return Files.readAllLines(STATUS).stream()
          .filter(line -> line.startsWith(RESIDENT))
          .map(line -> line.substring(RESIDENT.length()).strip().split(" ")[0])
          .mapToDouble(kib -> Double.parseDouble(kib) / 1024)
          .findFirst()
          .orElseThrow(
              () -> new SiteException("There is no %s in %s.".formatted(RESIDENT, STATUS)));
    } catch (IOException e) {
      throw new SiteException("What is resident is told by Linux only, in " + STATUS + ".", e);
    }
  }

  /**
   * All that is resident but the program and a heap that is resident as a whole: stacks, buffers,
   * what the C library keeps for compilers.
   */
  double restMiB() {
    return residentMiB - committedMiB - programMiB;
  }

  /** Least squares: by how much the figure grows in 100 goals. */
  static double slope(List<MemorySample> samples, ToDoubleFunction<MemorySample> figure) {
    double meanGoals = samples.stream().mapToDouble(MemorySample::goals).average().orElseThrow();
    double mean = samples.stream().mapToDouble(figure).average().orElseThrow();
    double together = 0;
    double squares = 0;
    for (MemorySample sample : samples) {
      double goals = sample.goals() - meanGoals;
      together += goals * (figure.applyAsDouble(sample) - mean);
      squares += goals * goals;
    }
    return 100 * together / squares;
  }

  String line() {
    return String.format(
        Locale.ROOT,
        "%5d goals: %7.2f MiB live, %7.2f MiB resident; heap %.2f, program %.2f",
        goals,
        heapMiB,
        residentMiB,
        committedMiB,
        programMiB);
  }
}
