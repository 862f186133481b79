package org.maestro.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.agents.content.GoalReport;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteException;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.sl.SlParser;

/**
 * Coordination under load, on a whole site: JADE agents, MQTT broker and simulated devices in one
 * process. First goals one after the other, warm, for the time from a goal's arrival to its first
 * call; then many goals stated within a second ({@link GoalBurst}). For one thread.
 */
public final class CoordinationBench {
  private static final int SPEED = 20;
  private static final Pattern QUESTIONS = Pattern.compile("Exact prices asked: (\\d+)");

  /** As many as it takes until the times no longer fall. */
  private static final int WARM_UP = 160;

  private static final int WARM_UP_LUX = 40;
  private static final int WARM_UP_ROUNDS = 5_000;
  private static final Duration MEASURED_TIME = Duration.ofSeconds(5);
  private static final long PATIENCE_SECONDS = 120;

  private final LargeHome large;
  private final int goals;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();

  /**
   * @param goals of the burst: two observe, two illuminate and one fetch of each five
   * @param progress told what is being done
   */
  public CoordinationBench(LargeHome large, int goals, Consumer<String> progress) {
    this.large = large;
    this.goals = goals;
    this.progress = progress;
  }

  public BenchReport run() {
    contractNet();
    progress.accept(
        "A site with %d robots whose prices are asked, then one whose prices are stated."
            .formatted(large.robots()));
    try (LocalSite site = LocalSite.paced(settings(large), SPEED)) {
      sequence(site, ", prices asked");
    }
    try (LocalSite site = LocalSite.paced(settings(large.withStatedPrices()), SPEED)) {
      sequence(site, ", prices stated");
    }
    try (LocalSite site = LocalSite.paced(settings(large.withStatedPrices()), 1)) {
      burst(site);
    }
    return new BenchReport("coordination", BenchReport.thisMachine(), rows);
  }

  private static SiteSettings settings(LargeHome large) {
    Home home = large.home();
    return SiteSettings.of("bench-coordination", home).scene(large.scene(home)).build();
  }

  /** Ten agents, as many as a home has. */
  private void contractNet() {
    progress.accept("Contract-net rounds beside those of plain JADE.");
    List<Device> devices = List.copyOf(new LargeHome(2, 0, 0).home().devices().values());
    try (TemporaryDirectory files = TemporaryDirectory.make()) {
      rows.add(
          ContractNetRounds.measure(devices, files.path(), WARM_UP_ROUNDS, MEASURED_TIME).row());
    }
  }

  private void sequence(LocalSite site, String prices) {
    Map<String, Integer> questions = new ConcurrentHashMap<>();
    site.platform()
        .onStory(
            entry -> {
              Matcher asked = QUESTIONS.matcher(entry.text());
              if (asked.find()) {
                questions.merge(entry.goalId(), Integer.parseInt(asked.group(1)), Integer::sum);
              }
            });
    List<Integer> ofFetches = new ArrayList<>();
    List<Double> quick = new ArrayList<>();
    List<Double> fetch = new ArrayList<>();
    int fetches = Math.max(1, large.robots() / 2);
    int looks = 2 * large.rooms();
    progress.accept(
        "%d goals one after the other, and %d before that nobody measures."
            .formatted(looks + fetches, WARM_UP + fetches));
    for (int i = 0; i < WARM_UP; i++) {
      ask(site, warmUpGoal(i, looks));
    }
    for (int i = 0; i < looks; i++) {
      note(ask(site, quickGoal(i, 0)), quick);
    }
    for (int i = 0; i < fetches; i++) {
      ask(site, fetchGoal(fetches + i, 1));
    }
    for (int i = 0; i < fetches; i++) {
      GoalReport report = ask(site, fetchGoal(i, 1));
      note(report, fetch);
      report.id().ifPresent(id -> ofFetches.add(questions.getOrDefault(id, 0)));
    }
    add("decision, observe and illuminate" + prices, quick);
    add("decision, fetch" + prices, fetch);
    List<Integer> sorted = ofFetches.stream().sorted().toList();
    rows.add(
        BenchReport.Row.of(
            "exact prices asked for a fetch" + prices + ", median",
            sorted.get(sorted.size() / 2),
            "questions"));
  }

  private void add(String name, List<Double> millis) {
    if (millis.isEmpty()) {
      throw new SiteException(
          "No goal of the kind '" + name + "' needed a call; nothing measured.");
    }
    rows.add(BenchReport.Row.of(name + ", goals measured", millis.size(), "goals"));
    rows.add(BenchReport.Row.of(name + ", p50", Quantile.of(millis, 0.5), "ms"));
    rows.add(BenchReport.Row.of(name + ", p99", Quantile.of(millis, 0.99), "ms"));
  }

  private static void note(GoalReport report, List<Double> millis) {
    if (report.calls() > 0) {
      millis.add(report.decisionMillis());
    }
  }

  private void burst(LocalSite site) {
    progress.accept("%d goals stated within one second, by two.".formatted(goals));
    rows.addAll(new GoalBurst(site, goals, this::goal).measure());
  }

  private String goal(int number) {
    return switch (number % 5) {
      case 0, 2 ->
          observeGoal(number % large.rooms(), number / large.rooms() % large.thingsPerRoom());
      case 1, 3 -> illuminateGoal(number % large.rooms());
      default -> fetchGoal(number % large.rooms(), number / large.rooms() % large.thingsPerRoom());
    };
  }

  private String quickGoal(int number, int thing) {
    int room = number / 2 % large.rooms();
    return number % 2 == 0 ? observeGoal(room, thing) : illuminateGoal(room);
  }

  /** Other things than those measured, and less light, in the same rooms. */
  private String warmUpGoal(int number, int looks) {
    int round = number / looks;
    int room = number / 2 % large.rooms();
    return number % 2 == 0
        ? observeGoal(room, 1 + round % (large.thingsPerRoom() - 1))
        : illuminateGoal(room, WARM_UP_LUX * (round + 1));
  }

  private String observeGoal(int room, int thing) {
    return "(canSee ?agent " + large.thing(room, thing) + ")";
  }

  private String illuminateGoal(int room) {
    return illuminateGoal(room, 200);
  }

  private String illuminateGoal(int room, int lux) {
    return "(>= (illuminance " + large.zone(room) + ") " + lux + ")";
  }

  private String fetchGoal(int room, int thing) {
    return "(nextTo " + large.thing(room, thing) + " " + large.person(room) + ")";
  }

  private static GoalReport ask(LocalSite site, String goal) {
    CompletableFuture<GoalReport> ended = new CompletableFuture<>();
    site.platform()
        .desk()
        .pursue(
            SlParser.formula(goal, site.platform().knowledge().home().vocabulary()::isFluent),
            id -> {},
            ended::complete);
    try {
      return ended.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    } catch (TimeoutException | ExecutionException e) {
      throw new SiteException("The goal " + goal + " did not end in time.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while waiting for " + goal + ".", e);
    }
  }
}
