package org.maestro.bench.console;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteException;
import org.maestro.assembly.SiteSettings;
import org.maestro.bench.BenchReport;
import org.maestro.bench.Quantile;
import org.maestro.console.Console;
import org.maestro.console.Serving;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.random.Building;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;

/**
 * The console as who looks at it has it: how soon the page is there, how soon the map shows what
 * was told on the bus, whether a building of a thousand devices with a hundred goals still moves,
 * and whether page and server grow while they stay open. For one thread.
 */
public final class ConsoleBench {
  private static final String SITE = "bench-console";
  private static final int LOADS = 10;
  private static final int EVENTS = 200;
  private static final int DEVICES_PER_FLOOR = 400;
  private static final int GOALS = 100;
  private static final long SEED = 1;
  private static final Duration WATCHED = Duration.ofSeconds(30);
  private static final double SPEED = 10;

  private final Home home;
  private final Scene scene;
  private final int devices;
  private final Duration open;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();

  /**
   * @param home Bob's: the lamp and the goals are his
   * @param devices of the building, about; one that does not get ready is left out
   * @param open how long the page is kept open to see what grows
   * @param progress told what is being done
   */
  public ConsoleBench(
      Home home, Scene scene, int devices, Duration open, Consumer<String> progress) {
    this.home = home;
    this.scene = scene;
    this.devices = devices;
    this.open = open;
    this.progress = progress;
  }

  public BenchReport run() {
    try (Chromium chromium = Chromium.start()) {
      SeenPage page = new SeenPage(chromium.page());
      inAHome(page);
      try {
        inABuilding(page);
      } catch (SiteException e) {
        progress.accept("Ended here: " + e.getMessage());
      }
    }
    return new BenchReport("console", BenchReport.thisMachine(), rows);
  }

  private void inAHome(SeenPage page) {
    SiteSettings settings = SiteSettings.of(SITE, home).scene(scene).build();
    try (LocalSite site = LocalSite.paced(settings, SPEED);
        Console console = console(site)) {
      progress.accept("The page is loaded %d times.".formatted(LOADS));
      List<Double> loads = new ArrayList<>();
      for (int load = 0; load < LOADS; load++) {
        loads.add(page.loadMillis(console.uri()));
      }
      add("page load, the first", loads.get(0), "ms");
      add("page load", loads, "ms");
      progress.accept("A lamp is set %d times.".formatted(EVENTS));
      try (SetLamp lamp = new SetLamp(site, SITE)) {
        add("from the bus to the map", lamp.millisUntilSeen(page, EVENTS), "ms");
      }
      progress.accept("The page stays open for %d min.".formatted(open.toMinutes()));
      rows.addAll(new OpenPage(site, page, progress).rows(open));
    }
  }

  private void inABuilding(SeenPage page) {
    Building building = new Building(devices, 1 + (devices - 1) / DEVICES_PER_FLOOR, SEED);
    Home large = new HomeLoader().load(building.homeText(), "building.ttl");
    SiteSettings settings =
        SiteSettings.of(SITE, large)
            .scene(
                SceneLoader.load(
                    "building-scene.ttl",
                    new ByteArrayInputStream(building.sceneText().getBytes(StandardCharsets.UTF_8)),
                    large))
            .build();
    progress.accept("A building of %d devices.".formatted(building.devices()));
    try (LocalSite site = LocalSite.paced(settings, 1);
        Console console = console(site)) {
      String of = building.devices() + " devices: ";
      add(of + "page load", page.loadMillis(console.uri()), "ms");
      for (int goal = 0; goal < GOALS; goal++) {
        String text =
            String.format(Locale.ROOT, "(keep (>= (illuminance z%d) 60))", goal % building.rooms());
        site.platform()
            .desk()
            .requestGoal(SlParser.formula(text, large.vocabulary()::isFluent), reply -> {});
      }
      for (String view : List.of("goals", "members", "knowledge")) {
        progress.accept("%d goals; the view %s.".formatted(GOALS, view));
        page.show(view);
        SeenPage.Frames frames = page.frames(WATCHED);
        add(of + view + ", time between frames", frames.millis(), "ms");
        add(of + view + ", longest task of the page", frames.longestTaskMillis(), "ms");
      }
    }
  }

  private static Console console(LocalSite site) {
    return Console.start(
        site.platform(),
        site.observer(),
        SITE,
        Serving.onLoopback(0),
        Optional.empty(),
        Optional.empty(),
        "bench");
  }

  private void add(String name, double value, String unit) {
    rows.add(BenchReport.Row.of(name, value, unit));
  }

  private void add(String name, List<Double> values, String unit) {
    add(name + ", p50", Quantile.of(values, 0.5), unit);
    add(name + ", p99", Quantile.of(values, 0.99), unit);
    add(name + ", max", Quantile.of(values, 1), unit);
  }
}
