package org.maestro.launch;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.Words;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.Console;
import org.maestro.console.documents.JsonMembers;
import org.maestro.ontology.home.Home;
import org.maestro.picture.TopView;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * A job from beginning to end on embedded parts, told as it happens and judged from the simulated
 * world.
 */
@Command(
    name = "demo",
    description = "The main job on embedded parts; without a name: Bob's cup in the dark.")
final class DemoCommand implements Callable<Integer> {
  private static final String NAME = "demo";
  private static final Duration PATIENCE = Duration.ofMinutes(10);
  private static final Map<String, String> GOALS =
      Map.of("bob", "(nextTo Cup Bob)", "arena", "(nextTo GreenObject RedObject1)");

  private static final List<String> DEMOS =
      List.of(
          "bob-dark",
          "bob-lit",
          "bob-cup-in-a",
          "bob-hidden",
          "bob-weak-lamps",
          "arena-dark",
          HousekeeperEvening.SCENE,
          FamilyEvening.NAME);

  /** The names of the demos, for shells that complete them. */
  static final class Demos implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return DEMOS.iterator();
    }
  }

  @Spec private CommandSpec spec;

  @Mixin private Allocation allocation;

  @Parameters(
      arity = "0..1",
      paramLabel = "NAME",
      completionCandidates = Demos.class,
      defaultValue = "bob-dark",
      description =
          "bob-dark, bob-lit, bob-cup-in-a, bob-hidden, bob-weak-lamps, arena-dark, housekeeper or"
              + " evening.")
  private String scene;

  @Option(
      names = "--speed",
      paramLabel = "N",
      defaultValue = "5",
      description = "Simulated seconds per second; default ${DEFAULT-VALUE}.")
  private double speed;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Of all chance in the world; default ${DEFAULT-VALUE}.")
  private long seed;

  @Option(
      names = "--console",
      description = "Show it in a page, too, and stay with it until Ctrl-C.")
  private boolean console;

  @Option(names = "--wine", description = "Of evening: Dave has wine, after which dinner goes on.")
  private boolean wine;

  @Option(names = "--json", description = "Print one JSON document instead of the story.")
  private boolean json;

  /** The result of a demo run, in the words of the JSON document. */
  private record Summary(
      String goal,
      boolean reached,
      GoalReport report,
      Optional<Duration> lowerBound,
      double wallSeconds,
      Path picture) {}

  @Override
  public Integer call() throws InterruptedException {
    long started = System.nanoTime();
    if (!DEMOS.contains(scene)) {
      throw CommandException.badInput(
          "There is no demo %s; there are %s.".formatted(scene, String.join(", ", DEMOS)));
    }
    Speed.require(speed);
    if (console && json) {
      throw CommandException.badInput("--console stays, --json prints and ends; leave one away.");
    }
    if (wine && !scene.equals(FamilyEvening.NAME)) {
      throw CommandException.badInput("--wine is for the demo evening; leave it away.");
    }
    if (scene.equals(HousekeeperEvening.SCENE)) {
      return evening();
    }
    if (scene.equals(FamilyEvening.NAME)) {
      return familyEvening();
    }
    String homeName = scene.substring(0, scene.indexOf('-'));
    Home home = Shipped.home(homeName);
    Scene truth = Shipped.scene(scene, home);
    String goal = Objects.requireNonNull(GOALS.get(homeName));
    PrintWriter out = spec.commandLine().getOut();
    if (!json) {
      out.println(
          Shipped.introduction(scene)
              .replaceFirst(
                  "^As bob-dark", "Bob sits in lit room A, cup and robot are in dark room B"));
      out.println("The goal: " + goal);
      out.println();
    }
    RuntimeDirectory directory = RuntimeDirectory.ofUser();
    try (LocalSite site = LocalSite.paced(settings(home, truth, directory), speed)) {
      Optional<Console> served = served(site, out);
      Optional<Duration> lowerBound = lowerBound(site, home, goal);
      TopView view = new TopView(home, site.world());
      GoalReport report = pursue(site, goal);
      Path picture = directory.picture(scene);
      view.write(picture);
      Summary summary =
          new Summary(
              goal,
              reached(site, goal),
              report,
              lowerBound,
              (System.nanoTime() - started) / 1e9,
              picture);
      tell(summary, out);
      if (served.isPresent()) {
        out.println();
        stay(site, served.get(), out);
      }
      return summary.reached() ? ExitCode.DONE : ExitCode.NOT_REACHED;
    }
  }

  private SiteSettings settings(Home home, Scene truth, RuntimeDirectory directory) {
    return SiteSettings.of(NAME, home)
        .scene(truth)
        .seed(seed)
        .storyDirectory(directory.beginStories(NAME))
        .allocation(allocation.objective())
        .build();
  }

  private Optional<Console> served(LocalSite site, PrintWriter out) {
    Optional<Console> served =
        console
            ? ConsoleOptions.usual().start(site, NAME, Optional.empty(), Optional.empty())
            : Optional.empty();
    served.ifPresent(page -> out.println("In a browser: " + page.uri()));
    return served;
  }

  /** What one goal after the other is for the other demos, several that never end are for this. */
  private Integer evening() throws InterruptedException {
    Home home = Shipped.home(HousekeeperEvening.HOME);
    PrintWriter out = spec.commandLine().getOut();
    RuntimeDirectory directory = RuntimeDirectory.ofUser();
    Scene truth = Shipped.scene(HousekeeperEvening.SCENE, home);
    try (LocalSite site = LocalSite.paced(settings(home, truth, directory), speed)) {
      if (!json) {
        out.println(Shipped.introduction(scene));
        out.println();
      }
      Optional<Console> served = served(site, out);
      HousekeeperEvening evening =
          new HousekeeperEvening(site, json ? Optional.empty() : Optional.of(out));
      evening.run();
      Path picture = evening.draw(directory.picture(scene));
      if (json) {
        out.println(evening.document(picture));
      } else {
        evening.tell(picture, out);
      }
      if (served.isPresent()) {
        out.println();
        stay(site, served.get(), out);
      }
      return evening.wentWell() ? ExitCode.DONE : ExitCode.NOT_REACHED;
    }
  }

  /** From event to event, as it takes the most part of an hour. */
  private Integer familyEvening() {
    if (console) {
      throw CommandException.badInput(
          "The demo evening goes from event to event and ends; leave --console away, or see it with"
              + " ./maestro run evening --scene homecoming --console.");
    }
    FamilyEvening evening =
        new FamilyEvening(
            wine, seed, json ? Optional.empty() : Optional.of(spec.commandLine().getOut()));
    evening.run(RuntimeDirectory.ofUser().beginStories(NAME));
    evening.tell(spec.commandLine().getOut());
    return evening.wentWell() ? ExitCode.DONE : ExitCode.NOT_REACHED;
  }

  private static void stay(LocalSite site, Console served, PrintWriter out)
      throws InterruptedException {
    UntilStopped.run(
        out,
        "The platform and its page stay: " + served.uri() + ".",
        () -> {
          served.close();
          site.close();
        });
  }

  private GoalReport pursue(LocalSite site, String goal) {
    if (!json) {
      StoryPrinter printer = new StoryPrinter(spec.commandLine().getOut(), site.clock().now());
      site.platform().onStory(printer::print);
    }
    CompletableFuture<GoalReport> ended = new CompletableFuture<>();
    site.platform().desk().pursue(SlParser.formula(goal), id -> {}, ended::complete);
    if (!site.runUntil(ended::isDone, PATIENCE)) {
      throw CommandException.outside(
          "The goal did not end within "
              + PATIENCE.toMinutes()
              + " simulated minutes; the log is "
              + RuntimeDirectory.ofUser().log()
              + ".");
    }
    return ended.join();
  }

  private static List<String> thingAndTarget(String goal) {
    Formula.Atom atom = (Formula.Atom) SlParser.formula(goal);
    return atom.arguments().stream().map(Words::plain).toList();
  }

  /** The world decides, not the platform. */
  private static boolean reached(LocalSite site, String goal) {
    List<String> names = thingAndTarget(goal);
    return site.world().isNextTo(names.get(0), names.get(1));
  }

  /** The least that any robot of the home needs. */
  private static Optional<Duration> lowerBound(LocalSite site, Home home, String goal) {
    List<String> names = thingAndTarget(goal);
    return home.devices().values().stream()
        .filter(device -> device.individual().properties().containsKey("payload"))
        .map(device -> lowerBound(site, device.id(), names))
        .flatMap(Optional::stream)
        .min(Duration::compareTo);
  }

  private static Optional<Duration> lowerBound(LocalSite site, String robot, List<String> names) {
    try {
      return Optional.of(site.simulated().lowerBound(robot, names.get(0), names.get(1)));
    } catch (SimulationException e) {
      // This robot cannot do it; another may.
      return Optional.empty();
    }
  }

  private void tell(Summary summary, PrintWriter out) {
    if (json) {
      out.println(document(summary));
      return;
    }
    GoalReport report = summary.report();
    out.println();
    out.println(
        summary.reached()
            ? "Reached: in the simulated world, " + summary.goal() + " is true."
            : "Not reached: in the simulated world, " + summary.goal() + " is not true.");
    report.reasons().forEach(reason -> out.println("  " + reason));
    out.printf(
        Locale.ROOT,
        "%.1f simulated seconds%s, calls: %d, replans: %d; %.0f ms from the goal to the first call;"
            + " %.1f s of wall time.%n",
        report.duration().toMillis() / 1000.0,
        summary
            .lowerBound()
            .map(
                bound ->
                    String.format(
                        Locale.ROOT,
                        " (nobody who knew everything could do it under %.1f)",
                        bound.toMillis() / 1000.0))
            .orElse(""),
        report.calls(),
        report.replans(),
        report.decisionMillis(),
        summary.wallSeconds());
    out.println("A picture of it, from above: " + summary.picture());
    out.println();
    out.println("Try next:");
    out.printf("  ./maestro why %-17s the whole story again%n", report.id().orElse("G1"));
    out.printf("  ./maestro demo --console        the same, in a page that stays open%n");
    out.printf("  ./maestro demo bob-weak-lamps   lamps weaker than they claim%n");
    out.printf(
        "  ./maestro run bob --gui         a platform that stays, to talk to from another"
            + " terminal%n");
  }

  private static String document(Summary summary) {
    GoalReport report = summary.report();
    JsonMembers members =
        JsonMembers.empty()
            .text("goal", summary.goal())
            .truth("reached", summary.reached())
            .number("simulated_s", report.duration().toMillis() / 1000.0)
            .number(
                "lower_bound_s",
                summary.lowerBound().stream()
                    .mapToDouble(bound -> bound.toMillis() / 1000.0)
                    .findFirst())
            .number("wall_s", Math.round(summary.wallSeconds() * 100) / 100.0);
    members.node().put("calls", report.calls()).put("replans", report.replans());
    return members
        .number("decision_ms", report.decisionMillis())
        .words("reasons", report.reasons())
        .text("picture", summary.picture().toString())
        .toString();
  }
}
