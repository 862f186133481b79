package org.maestro.chaos;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.Journal;
import org.maestro.ontology.home.Home;
import org.maestro.random.Fault;
import org.maestro.random.RandomHome;
import org.maestro.random.RandomHomes;
import org.maestro.random.RandomRun;
import org.maestro.random.Verdict;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;

/**
 * One random home on a bad bus, and what was found wrong.
 *
 * @param findings one line each: the kind first
 * @param claims how the judge found what was said of each goal
 */
public record ChaosRun(
    long seed, boolean withAgents, List<String> findings, List<Verdict.Kind> claims, String story) {

  /** Every so manieth seed is carried out by the whole platform, the others by its heart alone. */
  private static final int WITH_AGENTS = 8;

  /** Among so many seeds are homes of all kinds. */
  private static final int KINDS = 8;

  public ChaosRun {
    findings = List.copyOf(findings);
    claims = List.copyOf(claims);
  }

  /** Home, faults and chance all follow from the seed. */
  public static ChaosRun of(long seed) {
    boolean agents = seed % WITH_AGENTS == 0;
    try (Ledger ledger = new Ledger(seed)) {
      RandomHome quiet = home(seed, agents);
      List<Fault> faults = new ArrayList<>(quiet.faults());
      faults.addAll(new ChaosFaults(seed, agents).draw());
      if (!agents) {
        faults.addAll(ledger.draw(new Random(seed)));
      }
      return of(
          new RandomHome(seed, quiet.homeText(), quiet.sceneText(), quiet.goals(), faults),
          agents,
          ledger);
    }
  }

  /** Of all kinds. With agents a freeze is none of the home's faults. */
  private static RandomHome home(long seed, boolean agents) {
    return switch ((int) Math.floorMod(seed, (long) KINDS)) {
      case 0 -> agents ? RandomHomes.withLiars(seed) : RandomHomes.harsh(seed);
      case 1 -> RandomHomes.busy(seed);
      case 2, 5 -> RandomHomes.harsh(seed);
      case 3 -> ShippedHomes.of(seed);
      default -> RandomHomes.of(seed);
    };
  }

  private static ChaosRun of(RandomHome home, boolean agents, Ledger ledger) {
    Watcher watcher = new Watcher(new BusHistory(), ledger);
    List<String> findings = new ArrayList<>();
    List<Verdict.Kind> claims = new ArrayList<>();
    String story = "";
    try {
      RandomRun run =
          agents ? RandomRun.withAgents(home, watcher) : RandomRun.withoutAgents(home, watcher);
      run.verdicts().stream().map(Verdict::kind).forEach(claims::add);
      run.verdicts().stream()
          .filter(verdict -> !verdict.kind().agrees())
          .map(ChaosRun::finding)
          .forEach(findings::add);
      story = String.join("\n", run.story()) + "\n" + run.verdicts();
      findings.addAll(ledger.findings());
    } catch (RuntimeException broken) {
      findings.add("BROKEN " + broken + " at " + broken.getStackTrace()[0]);
    }
    findings.addAll(watcher.history().findings());
    return new ChaosRun(home.seed(), agents, findings, claims, home.faults() + "\n" + story);
  }

  /** An onlooker that has the bus and the journal looked at. */
  private record Watcher(BusHistory history, Ledger ledger) implements RandomRun.Onlooker {
    @Override
    public void begin(InProcessBus bus, Clock clock) {
      history.listen(bus, clock);
    }

    @Override
    public Journal journal(Home home, Clock clock) {
      return ledger.begin(home, clock);
    }

    @Override
    public void accepted(String goalId) {
      ledger.accepted(goalId);
    }

    @Override
    public void ended(GoalOutcome outcome) {
      ledger.ended(outcome);
    }
  }

  private static String finding(Verdict verdict) {
    return "%s %s: %s (%s)"
        .formatted(verdict.kind(), verdict.goal(), verdict.claim(), verdict.reason());
  }

  public boolean isClean() {
    return findings.isEmpty();
  }

  /** How to see it again. */
  public String command() {
    return "./maestro bench chaos --seed " + seed;
  }
}
