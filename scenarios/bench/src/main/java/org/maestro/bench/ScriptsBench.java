package org.maestro.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.maestro.agents.content.GoalReport;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteException;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.api.GoalState;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.TypedVariable;

/**
 * What scripts cost on a whole site: starting one, many that wait, and many side by side on the
 * stepped clock. Beside each stands what plain goals, or none, cost in the same run. For one
 * thread.
 */
public final class ScriptsBench {
  private static final int WARM_UP = 2_000;
  private static final int STARTED = 1_000;
  private static final Duration SETTLED = Duration.ofSeconds(5);
  private static final Duration MEASURED_TIME = Duration.ofSeconds(20);
  private static final int STEPS = 20;
  private static final Duration LONGEST_RUN = Duration.ofHours(2);
  private static final long PATIENCE_SECONDS = 120;

  /** A script that is over at once, and a goal that is so already. */
  private static final String AT_ONCE = "(atOnce)";

  private static final String SO_ALREADY = "(inside lamp-0-0 z0)";
  private static final List<String> WAITING =
      List.of("(waitForTime)", "(waitForLight z0)", "(waitForLight z1)");

  private final int waiting;
  private final int sideBySide;
  private final LargeHome large;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();

  /**
   * @param waiting how many scripts wait at once
   * @param sideBySide how many scripts of twenty steps are carried out at once, each with a lamp of
   *     its own
   * @param progress told what is being done
   */
  public ScriptsBench(int waiting, int sideBySide, Consumer<String> progress) {
    this.waiting = waiting;
    this.sideBySide = sideBySide;
    this.large = new LargeHome((sideBySide + LargeHome.LAMPS - 1) / LargeHome.LAMPS, 0, 0);
    this.progress = progress;
  }

  public BenchReport run() {
    Home home = withScripts(large.home());
    try (LocalSite site = LocalSite.paced(settings(home), 1)) {
      starting(site);
      waiting(site);
    }
    sideBySide(home);
    return new BenchReport("scripts", BenchReport.thisMachine(), rows);
  }

  private SiteSettings settings(Home home) {
    return SiteSettings.of("bench-scripts", home).scene(large.scene(home)).build();
  }

  private static Home withScripts(Home home) {
    Map<String, Script> scripts = new TreeMap<>();
    add(scripts, home, "atOnce", List.of(), "(return 1)");
    add(scripts, home, "waitForTime", List.of(), "(wait 100000)");
    add(scripts, home, "waitForLight", List.of("?z - Zone"), "(wait (> (illuminance ?z) 99999))");
    List<String> lamp = List.of("?lamp - Lamp");
    add(scripts, home, "blinkByCalls", lamp, steps("(do adjustLight ?lamp :level %d)"));
    add(scripts, home, "blinkByGoals", lamp, steps("(achieve (= (level ?lamp) %d))"));
    return home.withScripts(scripts);
  }

  private static void add(
      Map<String, Script> scripts, Home home, String name, List<String> parameters, String body) {
    List<TypedVariable> variables = parameters.stream().map(SlParser::variable).toList();
    scripts.put(
        name, new Script(name, variables, SlParser.body(body, home.vocabulary()::isFluent)));
  }

  private static String steps(String step) {
    return IntStream.rangeClosed(1, STEPS)
        .mapToObj(number -> step.formatted(number % 2))
        .collect(Collectors.joining(" ", "(seq ", ")"));
  }

  private void starting(LocalSite site) {
    progress.accept("%d scripts that are over at once, one after the other.".formatted(STARTED));
    for (int i = 0; i < WARM_UP; i++) {
      started(site, AT_ONCE);
      started(site, SO_ALREADY);
    }
    List<Started> scripts = new ArrayList<>();
    List<Started> goals = new ArrayList<>();
    for (int i = 0; i < STARTED; i++) {
      scripts.add(started(site, AT_ONCE));
      goals.add(started(site, SO_ALREADY));
    }
    for (double part : new double[] {0.5, 0.99}) {
      String quantile = ", p%.0f".formatted(part * 100);
      rows.add(
          new BenchReport.Row(
              "from stating a script to its being agreed to" + quantile,
              Quantile.of(scripts.stream().map(Started::agreedMillis).toList(), part),
              "ms",
              OptionalDouble.of(
                  Quantile.of(goals.stream().map(Started::agreedMillis).toList(), part))));
      rows.add(
          new BenchReport.Row(
              "from stating a script that is over at once to its end" + quantile,
              Quantile.of(scripts.stream().map(Started::endedMillis).toList(), part),
              "ms",
              OptionalDouble.of(
                  Quantile.of(goals.stream().map(Started::endedMillis).toList(), part))));
    }
  }

  private record Started(double agreedMillis, double endedMillis) {}

  private static Started started(LocalSite site, String goal) {
    Formula formula = formula(site, goal);
    CompletableFuture<Long> agreed = new CompletableFuture<>();
    CompletableFuture<GoalReport> ended = new CompletableFuture<>();
    CompletableFuture<Long> end = ended.thenApply(report -> System.nanoTime());
    long begun = System.nanoTime();
    site.platform()
        .desk()
        .pursue(formula, id -> agreed.complete(System.nanoTime()), ended::complete);
    Started started =
        new Started((get(agreed, goal) - begun) / 1e6, (get(end, goal) - begun) / 1e6);
    mustBeReached(goal, get(ended, goal));
    return started;
  }

  private void waiting(LocalSite site) {
    progress.accept("The site without goals, and with %d scripts that wait.".formatted(waiting));
    double without = busyness();
    AtomicInteger agreed = new AtomicInteger();
    for (int i = 0; i < waiting; i++) {
      site.platform()
          .desk()
          .pursue(
              formula(site, WAITING.get(i % WAITING.size())),
              id -> agreed.incrementAndGet(),
              report -> {});
    }
    Waiting.until(() -> agreed.get() == waiting, waiting + " scripts are under way");
    rows.add(
        new BenchReport.Row(
            "processor time with %d scripts that wait; baseline: with none".formatted(waiting),
            busyness(),
            "ms/s",
            OptionalDouble.of(without)));
  }

  /** Milliseconds of processor time that this process takes in a second. */
  private static double busyness() {
    LockSupport.parkNanos(SETTLED.toNanos());
    long begun = System.nanoTime();
    double before = ProcessorTime.seconds();
    LockSupport.parkNanos(MEASURED_TIME.toNanos());
    return 1_000 * (ProcessorTime.seconds() - before) / Waiting.secondsSince(begun);
  }

  private void sideBySide(Home home) {
    progress.accept(
        "%d lamps, each switched %d times: by plain goals, by goals of a script, by its calls."
            .formatted(sideBySide, STEPS));
    goals(home);
    double plain = goals(home);
    scripts(home, "blinkByGoals");
    addThroughput("achieve", scripts(home, "blinkByGoals"), plain);
    scripts(home, "blinkByCalls");
    addThroughput("do", scripts(home, "blinkByCalls"), plain);
  }

  private void addThroughput(String form, double stepsPerSecond, double plain) {
    rows.add(
        new BenchReport.Row(
            "%d scripts of %d %s; baseline: plain goals".formatted(sideBySide, STEPS, form),
            stepsPerSecond,
            "steps/s",
            OptionalDouble.of(plain)));
  }

  private String lamp(int number) {
    return large.lamp(number / LargeHome.LAMPS, number % LargeHome.LAMPS);
  }

  /** The same as the scripts, by one who states each goal once the one before is reached. */
  private double goals(Home home) {
    return stepsPerSecond(home, (site, lamp, over) -> new Chain(site, lamp, over).state(1));
  }

  private record Chain(LocalSite site, String lamp, Runnable over) {

    private void state(int number) {
      pursue(
          site,
          "(= (level %s) %d)".formatted(lamp, number % 2),
          number < STEPS ? () -> state(number + 1) : over);
    }
  }

  private double scripts(Home home, String script) {
    return stepsPerSecond(
        home, (site, lamp, over) -> pursue(site, "(%s %s)".formatted(script, lamp), over));
  }

  private static void pursue(LocalSite site, String goal, Runnable reached) {
    site.platform()
        .desk()
        .pursue(
            formula(site, goal),
            id -> {},
            report -> {
              mustBeReached(goal, report);
              reached.run();
            });
  }

  /** What is done with each lamp. */
  private interface Blinking {
    void begin(LocalSite site, String lamp, Runnable over);
  }

  private double stepsPerSecond(Home home, Blinking blinking) {
    try (LocalSite site = LocalSite.stepped(settings(home))) {
      AtomicInteger over = new AtomicInteger();
      long begun = System.nanoTime();
      for (int i = 0; i < sideBySide; i++) {
        blinking.begin(site, lamp(i), over::incrementAndGet);
      }
      if (!site.runUntil(() -> over.get() == sideBySide, LONGEST_RUN)) {
        throw new SiteException(
            "%d of %d lamps were not switched %d times within %d h."
                .formatted(sideBySide - over.get(), sideBySide, STEPS, LONGEST_RUN.toHours()));
      }
      return sideBySide * STEPS / Waiting.secondsSince(begun);
    }
  }

  private static void mustBeReached(String goal, GoalReport report) {
    if (report.state() != GoalState.ACHIEVED) {
      throw new SiteException(goal + " was not reached: " + String.join(" ", report.reasons()));
    }
  }

  private static Formula formula(LocalSite site, String goal) {
    return SlParser.formula(goal, site.home().vocabulary()::isFluent);
  }

  private static <T> T get(CompletableFuture<T> what, String goal) {
    try {
      return what.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    } catch (TimeoutException | ExecutionException e) {
      throw new SiteException("The goal " + goal + " did not end in time.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while waiting for " + goal + ".", e);
    }
  }
}
