package org.maestro.bench.tracking;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.bench.BenchReport;
import org.maestro.bench.Quantile;
import org.maestro.bench.TemporaryDirectory;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * How well persons are followed (A2, A74): the share of the time for which it is told rightly where
 * each is, how far what is told with a confidence is so, how early it is told where she goes next;
 * and, in the same run, where she would be if she were still where a camera has seen her last. For
 * one thread.
 */
public final class TrackingBench {
  private static final Duration EVENING = Duration.ofMinutes(40);
  private static final Duration STEP = Duration.ofSeconds(1);

  /** Until devices have joined and said what they notice. */
  private static final Duration BEGINNING = Duration.ofSeconds(30);

  /** Radars that miss and err, as the home's words assume of them. */
  private static final Map<String, String> ERRORS =
      Map.of("world.presence.missShare", "0.05", "world.presence.falseShare", "0.02");

  private final Home home;
  private final int runs;
  private final long seed;
  private final Consumer<String> progress;
  private final FloorWays ways;
  private final List<String> persons;
  private final Evenings evenings;
  private final Calibration supposed = new Calibration();
  private final Calibration sure = new Calibration();
  private final Foretold foretold = new Foretold();
  private final Counts counts = new Counts();

  /** How often, of all looks at a person. */
  private static final class Counts {
    private long looks;
    private long right;
    private long wrong;
    private long sure;
    private long sureAndWrong;
    private long lastSeenRight;
  }

  /**
   * A benchmark.
   *
   * @param scene with a place for each person who is followed
   * @param runs how many evenings; each learns of the ones before
   * @param seed of the first
   * @param progress told what is being done
   */
  public TrackingBench(Home home, Scene scene, int runs, long seed, Consumer<String> progress) {
    this.home = home;
    this.runs = runs;
    this.seed = seed;
    this.progress = progress;
    this.ways = new FloorWays(home);
    String tracked = home.tracking().orElseThrow().tracked();
    this.persons =
        home.individuals().values().stream()
            .filter(one -> one.classes().contains(tracked))
            .map(Individual::name)
            .toList();
    this.evenings = new Evenings(ways, scene, persons);
  }

  public BenchReport run() {
    try (TemporaryDirectory directory = TemporaryDirectory.make()) {
      for (int run = 0; run < runs; run++) {
        foretold.begin();
        progress.accept("Evening %d of %d".formatted(run + 1, runs));
        evening(evenings.evening(seed + run), seed + run, directory.path());
      }
    }
    return new BenchReport("tracking", BenchReport.thisMachine(), rows(), summary());
  }

  private void evening(Scene evening, long ofSeed, Path directory) {
    SiteSettings settings =
        SiteSettings.of("bench-tracking", home)
            .scene(evening)
            .seed(ofSeed)
            .dataDirectory(directory)
            .physics(PhysicalParameters.standard().with(ERRORS))
            .build();
    try (LocalSite site = LocalSite.stepped(settings)) {
      LastSeen lastSeen = new LastSeen(site.platform().knowledge(), cameras(site));
      site.runUntil(() -> false, BEGINNING);
      for (Duration at = Duration.ZERO; at.compareTo(EVENING) < 0; at = at.plus(STEP)) {
        site.runUntil(() -> false, STEP);
        persons.forEach(person -> look(site, lastSeen, person));
      }
    }
  }

  private Map<String, String> cameras(LocalSite site) {
    Snapshot facts = site.platform().knowledge().snapshot();
    Map<String, String> zones = new LinkedHashMap<>();
    for (Term.Name camera : facts.individuals("RecognisingCamera")) {
      for (String zone : ways.zones()) {
        Formula.Atom inside = new Formula.Atom("inside", List.of(camera, new Term.Name(zone)));
        if (facts.truth(inside) == Truth.TRUE) {
          zones.put(camera.text(), zone);
        }
      }
    }
    return zones;
  }

  private void look(LocalSite site, LastSeen lastSeen, String person) {
    Optional<String> truly = site.world().zone(person);
    if (truly.isEmpty()) {
      return;
    }
    String zone = truly.get();
    Snapshot facts = site.platform().knowledge().snapshot();
    counts.looks++;
    counts.lastSeenRight += lastSeen.zone(person).filter(zone::equals).isPresent() ? 1 : 0;
    Optional<Belief> known = told(facts, "in", person);
    Optional<Belief> likely = told(facts, "probablyIn", person);
    likely.ifPresent(
        belief -> {
          boolean isSo = isSo(belief, zone);
          supposed.add(belief.confidence(), isSo);
          counts.right += isSo ? 1 : 0;
          counts.wrong += isSo ? 0 : 1;
        });
    known.ifPresent(
        belief -> {
          boolean isSo = isSo(belief, zone);
          sure.add(belief.confidence(), isSo);
          counts.sure++;
          counts.sureAndWrong += isSo ? 0 : 1;
        });
    Optional<Belief> heading = told(facts, "headingTo", person);
    foretold.note(
        person,
        zone,
        evenings.isRoom(zone),
        heading.map(TrackingBench::zone),
        heading.map(Belief::confidence).orElse(0.0),
        site.clock().now());
  }

  private static Optional<Belief> told(Snapshot facts, String word, String person) {
    return facts
        .value(word, List.of(new Term.Name(person)))
        .flatMap(
            zone -> facts.belief(new Formula.Atom(word, List.of(new Term.Name(person), zone))));
  }

  private static String zone(Belief belief) {
    return belief.fact().replaceFirst("^\\(\\S+ \\S+ (\\S+)\\)$", "$1");
  }

  private static boolean isSo(Belief belief, String zone) {
    return zone(belief).equals(zone);
  }

  private List<BenchReport.Row> rows() {
    List<BenchReport.Row> rows = new ArrayList<>();
    double looks = counts.looks;
    double lastSeenRight = counts.lastSeenRight / looks;
    rows.add(
        new BenchReport.Row(
            "rightly told where, of the time; baseline: last seen by a camera",
            100 * counts.right / looks,
            "%",
            OptionalDouble.of(100 * lastSeenRight)));
    rows.add(
        new BenchReport.Row(
            "wrongly told where, of the time; baseline: last seen by a camera",
            100 * counts.wrong / looks,
            "%",
            OptionalDouble.of(100 * (1 - lastSeenRight))));
    rows.add(BenchReport.Row.of("told as known, of the time", 100 * counts.sure / looks, "%"));
    rows.add(
        BenchReport.Row.of(
            "wrong, of what is told as known", 100.0 * counts.sureAndWrong / counts.sure, "%"));
    rows.add(
        new BenchReport.Row(
            "Brier score of what is told; baseline: last seen, taken as certain",
            supposed.brier(),
            "",
            OptionalDouble.of(1 - lastSeenRight)));
    rows.add(BenchReport.Row.of("calibration error of what is told", supposed.error(), ""));
    rows.add(BenchReport.Row.of("moves into a room", foretold.moves(), ""));
    rows.add(BenchReport.Row.of("next rooms foretold", foretold.told(), ""));
    rows.add(
        BenchReport.Row.of(
            "of them so within a minute",
            100.0 * foretold.leadSeconds().size() / Math.max(1, foretold.told()),
            "%"));
    if (!foretold.leadSeconds().isEmpty()) {
      rows.add(
          BenchReport.Row.of(
              "told before the arrival, p50", Quantile.of(foretold.leadSeconds(), 0.5), "s"));
    }
    return rows;
  }

  private List<String> summary() {
    List<String> lines = new ArrayList<>();
    lines.add("Where somebody probably is:");
    lines.addAll(supposed.lines());
    lines.add("Where somebody is told to be known to be:");
    lines.addAll(sure.lines());
    lines.add("Where somebody is told to be heading:");
    lines.addAll(foretold.calibration().lines());
    lines.add(
        ("%d evenings of %d minutes, %d persons, looked at every second; radars miss 5 %% and err"
                + " 2 %% of the time, cameras 10 %% and 0.5 %%, receivers of phones 30 %% and 5 %%.")
            .formatted(runs, EVENING.toMinutes(), persons.size()));
    return lines;
  }
}
