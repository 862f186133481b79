package org.maestro.bench.planning;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * One plan for a home in a process of its own, as a person has it who asks {@code ./maestro plan}
 * not for the first time: the home is loaded and checked in it too, and Java takes the classes from
 * an archive, where it can have one.
 *
 * @param seconds from the start of the process to its end
 * @param mebibytes the most memory that the process has had; 0 where the system does not tell
 * @param exitCode that of the command; the process is killed when time is over
 */
record ColdPlan(double seconds, double mebibytes, int exitCode) {
  private static final String PROGRAM = "org.maestro.launch.Maestro";
  private static final long BETWEEN_LOOKS_MILLIS = 20;
  private static final int KILLED = -1;

  boolean isPlanned() {
    return exitCode == 0;
  }

  /**
   * @param archive what {@link #leaveClasses} has left
   */
  static ColdPlan of(Path home, String goal, Duration limit, Path archive) {
    return of(home, goal, limit, "-XX:SharedArchiveFile=" + archive);
  }

  /** Plans once, and has the classes left that it takes. */
  static void leaveClasses(Path home, String goal, Duration limit, Path archive) {
    of(home, goal, limit, "-XX:ArchiveClassesAtExit=" + archive);
  }

  private static ColdPlan of(Path home, String goal, Duration limit, String classes) {
    List<String> command =
        List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=4",
            "-Xshare:auto",
            classes,
            "-Djava.awt.headless=true",
            "-cp",
            System.getProperty("java.class.path"),
            PROGRAM,
            "plan",
            home.toString(),
            goal);
    try {
      long begin = System.nanoTime();
      Process process =
          new ProcessBuilder(command)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      double mebibytes = 0;
      while (!process.waitFor(BETWEEN_LOOKS_MILLIS, TimeUnit.MILLISECONDS)) {
        mebibytes = Math.max(mebibytes, mostMebibytes(process.pid()));
        if (System.nanoTime() - begin > limit.toNanos()) {
          process.destroyForcibly().onExit().join();
          return new ColdPlan(limit.toMillis() / 1e3, mebibytes, KILLED);
        }
      }
      return new ColdPlan((System.nanoTime() - begin) / 1e9, mebibytes, process.exitValue());
    } catch (IOException e) {
      throw new UncheckedIOException("A process for the benchmark could not be started.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("The benchmark was interrupted", e);
    }
  }

  private static double mostMebibytes(long process) {
    File status = new File("/proc/" + process + "/status");
    try (Stream<String> lines = Files.lines(status.toPath())) {
      return lines
          .filter(line -> line.startsWith("VmHWM:"))
          .mapToDouble(line -> Long.parseLong(line.replaceAll("\\D", "")) / 1_024.0)
          .findFirst()
          .orElse(0);
    } catch (IOException | UncheckedIOException e) {
      return 0;
    }
  }
}
