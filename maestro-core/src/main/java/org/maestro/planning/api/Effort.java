package org.maestro.planning.api;

/**
 * The search budget of one plan: how much the searches for it may cost together, counted and not
 * timed, so that the same task has the same plan on any machine. For one thread at a time.
 */
public final class Effort {
  /** Some seconds; a plan that comes later than that helps nobody, however cheap it is. */
  private static final long FOR_ONE_PLAN = 2_000_000;

  /** About a tenth of a second. */
  private static final long FOR_SOON_FOUND_PLAN = FOR_ONE_PLAN / 8;

  /** Without any plan the goal is given up: that is worth more than a proof. */
  private static final long FOR_ANY_PLAN = 4 * FOR_ONE_PLAN;

  /** The work that is left, shared by the searches of one effort. */
  private static final class Work {
    private long left;

    private Work(long left) {
      this.left = left;
    }
  }

  private final int mostStates;
  private final Work work;

  /**
   * @param mostStates kept at once by one search
   * @param mostEstimates made by all searches: states, each times the operators that an estimate
   *     looks at
   */
  private Effort(int mostStates, long mostEstimates) {
    this(mostStates, new Work(mostEstimates));
  }

  private Effort(int mostStates, Work work) {
    this.mostStates = mostStates;
    this.work = work;
  }

  /** For the best plan, and the proof that it is. */
  public static Effort forBestPlan(int mostStates) {
    return new Effort(mostStates, FOR_ONE_PLAN);
  }

  /** For some plan, or the proof that there is none. */
  public static Effort forAnyPlan(int mostStates) {
    return new Effort(mostStates, FOR_ANY_PLAN);
  }

  /** For a plan that is soon found, where another search is there for all others. */
  public static Effort forSoonFoundPlan(int mostStates) {
    return new Effort(mostStates, FOR_SOON_FOUND_PLAN);
  }

  /** Out of the same effort, for a search that is worth no more states than these. */
  public Effort within(int states) {
    return new Effort(Math.min(states, mostStates), work);
  }

  public int mostStates() {
    return mostStates;
  }

  /** One more state is estimated. */
  public void spend(int operators) {
    work.left -= operators;
  }

  public boolean isSpent() {
    return work.left < 0;
  }
}
