package org.maestro.chaos;

import java.util.ArrayList;
import java.util.List;
import org.maestro.random.Fault;
import org.maestro.random.RandomHome;
import org.maestro.random.RandomHomes;
import org.maestro.random.RandomRun;
import org.maestro.random.Verdict;

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

  /** Every so manieth has many goals at once, which takes the planner long. */
  private static final int BUSY = 8;

  public ChaosRun {
    findings = List.copyOf(findings);
    claims = List.copyOf(claims);
  }

  /** Home, faults and chance all follow from the seed. */
  public static ChaosRun of(long seed) {
    RandomHome quiet = seed % BUSY == 1 ? RandomHomes.busy(seed) : RandomHomes.of(seed);
    List<Fault> faults = new ArrayList<>(quiet.faults());
    faults.addAll(new ChaosFaults(seed).draw());
    RandomHome home =
        new RandomHome(seed, quiet.homeText(), quiet.sceneText(), quiet.goals(), faults);
    BusHistory history = new BusHistory();
    boolean agents = seed % WITH_AGENTS == 0;
    List<String> findings = new ArrayList<>();
    List<Verdict.Kind> claims = new ArrayList<>();
    String story = "";
    try {
      RandomRun run =
          agents
              ? RandomRun.withAgents(home, history::listen)
              : RandomRun.withoutAgents(home, history::listen);
      run.verdicts().stream().map(Verdict::kind).forEach(claims::add);
      run.verdicts().stream()
          .filter(verdict -> !verdict.kind().agrees())
          .map(ChaosRun::finding)
          .forEach(findings::add);
      story = String.join("\n", run.story()) + "\n" + run.verdicts();
    } catch (RuntimeException broken) {
      findings.add("BROKEN " + broken + " at " + broken.getStackTrace()[0]);
    }
    findings.addAll(history.findings());
    return new ChaosRun(seed, agents, findings, claims, faults + "\n" + story);
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
