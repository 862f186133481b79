package org.maestro.bench.planning;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.GrowingTask;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/**
 * The planner on random homes of 10 to 1,000 agents, in one warm process, grounding included: the
 * time until the first plan, and until it is proven that none is cheaper, or the gap that is left
 * at a deadline. Beside that the times of Fast Downward with landmark cuts (the baseline) and of
 * ENHSP for the same problems, in processes of their own, as far as they are installed. One busy
 * thread.
 */
public final class PlannerBench {
  private static final int[] AGENTS = {10, 100, 1000};
  private static final int RUNS = 5;
  private static final long MEMORY = 1_500_000_000L;

  private final double deadlineSeconds;
  private final List<Peer> peers;
  private final Consumer<String> progress;
  private final String domain = resource("/planning/home-domain.pddl");

  /**
   * @param deadlineSeconds for the proof of each problem, and for the peer's
   * @param progress told what is being done
   */
  public PlannerBench(double deadlineSeconds, Consumer<String> progress) {
    this.deadlineSeconds = deadlineSeconds;
    this.progress = progress;
    this.peers = Peer.all(deadlineSeconds);
  }

  /** Measures, one problem after the other. */
  public BenchReport run() {
    peers.forEach(peer -> progress.accept(peer.standing()));
    warmUp();
    List<BenchReport.Row> rows = new ArrayList<>();
    PlannerTable table = new PlannerTable();
    for (int agents : AGENTS) {
      for (PlanningHome.Wish wish : PlanningHome.Wish.values()) {
        String problem = new PlanningHome(agents, 1).problem(wish);
        String name = "%d agents, %s".formatted(agents, wish.words());
        progress.accept(name);
        table.add(agents, measure(name, wish.words(), problem, rows));
      }
    }
    rows.addAll(new ReplanningBench(progress).rows());
    List<String> summary = new ArrayList<>(table.lines());
    peers.forEach(peer -> summary.add(peer.standing() + "."));
    return new BenchReport("planner", BenchReport.thisMachine(), rows, summary);
  }

  private void warmUp() {
    progress.accept("warming up");
    for (int i = 0; i < 20; i++) {
      for (PlanningHome.Wish wish : PlanningHome.Wish.values()) {
        LiftedTask task = read(new PlanningHome(i < 15 ? 10 : 100, i).problem(wish));
        solve(task, GroundingBudget.seconds(0.5, () -> false));
      }
    }
  }

  private LiftedTask read(String problem) {
    return PddlReader.parse("domain", domain, "problem", problem);
  }

  private static Solution solve(LiftedTask task, GroundingBudget patience) {
    return new AnytimePlanner(Grounder.growing(task, patience), MEMORY, line -> {}).solve(patience);
  }

  private PlannerTable.Entry measure(
      String name, String wish, String problem, List<BenchReport.Row> rows) {
    LiftedTask task = read(problem);
    double[] first = new double[RUNS];
    for (int run = 0; run < RUNS; run++) {
      first[run] =
          milliseconds(
              () -> {
                GrowingTask ground = Grounder.growing(task, GroundingBudget.endless());
                new AnytimePlanner(ground, MEMORY, line -> {}).first(GroundingBudget.endless());
              });
    }
    rows.add(BenchReport.Row.of(name + ": first plan", median(first), "ms"));
    Solution[] last = new Solution[1];
    List<Double> proofs = new ArrayList<>();
    for (int run = 0; run < RUNS && (run == 0 || proofs.get(0) < 2000); run++) {
      proofs.add(
          milliseconds(
              () -> last[0] = solve(task, GroundingBudget.seconds(deadlineSeconds, () -> false))));
    }
    List<String> others = new ArrayList<>();
    OptionalDouble baseline = OptionalDouble.empty();
    for (Peer peer : peers) {
      Optional<Peer.Outcome> outcome = peer.solve(domain, problem);
      outcome.ifPresent(done -> others.add(peer.name() + " " + done.text()));
      OptionalDouble time =
          outcome.map(Peer.Outcome::milliseconds).orElseGet(OptionalDouble::empty);
      if (peer == peers.get(0)) {
        baseline = time;
      } else if (time.isPresent()) {
        rows.add(BenchReport.Row.of(name + ": " + peer.name(), time.getAsDouble(), "ms"));
      }
    }
    double proof = median(proofs.stream().mapToDouble(Double::doubleValue).toArray());
    String end =
        last[0].verdict() == Solution.Verdict.OPTIMAL
            ? ": proven cheapest, cost " + cost(last[0].cost(), task)
            : last[0].hasPlan()
                ? ": stopped, cost %s, bound %s"
                    .formatted(cost(last[0].cost(), task), cost(last[0].lowerBound(), task))
                : ": " + last[0].verdict().name().toLowerCase(Locale.ROOT);
    rows.add(new BenchReport.Row(name + end, proof, "ms", baseline));
    return new PlannerTable.Entry(wish, median(first), proof, last[0], others);
  }

  private static String cost(long units, LiftedTask task) {
    BigDecimal unit = Grounder.ground(task, GroundingBudget.endless()).unit();
    return BigDecimal.valueOf(units).divide(unit).stripTrailingZeros().toPlainString();
  }

  private static double milliseconds(Runnable work) {
    long start = System.nanoTime();
    work.run();
    return (System.nanoTime() - start) / 1e6;
  }

  private static double median(double[] values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[sorted.length / 2];
  }

  private static String resource(String name) {
    try (InputStream in = PlannerBench.class.getResourceAsStream(name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
