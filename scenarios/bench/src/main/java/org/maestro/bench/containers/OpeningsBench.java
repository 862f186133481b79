package org.maestro.bench.containers;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;
import org.maestro.bench.MaestroProcess;
import org.maestro.bench.TemporaryDirectory;

/**
 * A site with many devices, opened again and again, each time by a new process: how often all its
 * devices come, and how long that takes. Members, broker and platform begin at the same moment, so
 * that each message may meet a subscription that is just being made. For one thread.
 */
public final class OpeningsBench {
  private static final int PER_HALL = 400;
  private static final double NANOS_IN_SECOND = 1e9;

  private final int devices;
  private final int runs;
  private final Consumer<String> progress;

  /**
   * @param runs from 1
   * @param progress told how each opening went
   */
  public OpeningsBench(int devices, int runs, Consumer<String> progress) {
    this.devices = devices;
    this.runs = runs;
    this.progress = progress;
  }

  public BenchReport run() {
    List<Double> seconds = new ArrayList<>();
    try (TemporaryDirectory directory = TemporaryDirectory.make()) {
      Path home = directory.path().resolve("crowded.ttl");
      CrowdedHome crowded = new CrowdedHome(devices, PER_HALL);
      Files.writeString(home, crowded.turtle(), UTF_8);
      Path scene = directory.path().resolve("scene.ttl");
      Files.writeString(scene, crowded.scene(), UTF_8);
      for (int run = 1; run <= runs; run++) {
        open(home, scene, run, seconds);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("The home of the benchmark cannot be written.", e);
    }
    List<BenchReport.Row> rows = new ArrayList<>();
    rows.add(BenchReport.Row.of("openings with %d devices".formatted(devices), runs, "times"));
    rows.add(BenchReport.Row.of("of these all devices came", seconds.size(), "times"));
    if (!seconds.isEmpty()) {
      Collections.sort(seconds);
      rows.add(
          BenchReport.Row.of("until all were there, p50", seconds.get(seconds.size() / 2), "s"));
      rows.add(
          BenchReport.Row.of("until all were there, most", seconds.get(seconds.size() - 1), "s"));
    }
    return new BenchReport("openings", BenchReport.thisMachine(), rows);
  }

  private void open(Path home, Path scene, int run, List<Double> seconds) {
    long begin = System.nanoTime();
    try (MaestroProcess site =
        MaestroProcess.start(
            List.of(),
            List.of("run", home.toString(), "--scene", scene.toString(), "--port", "0"))) {
      try {
        site.awaitSaying("The platform maestro runs");
        double took = (System.nanoTime() - begin) / NANOS_IN_SECOND;
        seconds.add(took);
        progress.accept("%3d: all came, in %.1f s".formatted(run, took));
      } catch (IllegalStateException missing) {
        progress.accept("%3d: %s".formatted(run, missing.getMessage()));
      }
    }
  }
}
