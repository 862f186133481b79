package org.maestro.planning.api;

/**
 * The search budget of one plan: how much the searches for it may cost together, counted and not
 * timed, so that the same task has the same plan on any machine. For one thread at a time.
 */
public final class Effort {
  /** Some seconds; a plan that comes later than that helps nobody, however cheap it is. */
  private static final long FOR_ONE_PLAN = 64_000_000;

  /** Some hundredths of a second, in which most plans are found that this search finds at all. */
  private static final long FOR_SOON_FOUND_PLAN = FOR_ONE_PLAN / 64;

  private static final long FOR_PLAN_BESIDE = FOR_ONE_PLAN / 16;

  /** Without any plan the goal is given up: that is worth more than a proof. */
  private static final long FOR_ANY_PLAN = 4 * FOR_ONE_PLAN;

  private final int mostStates;
  private long left;

  /**
   * @param mostStates kept at once by one search
   * @param work how often all searches together may look at an action
   */
  private Effort(int mostStates, long work) {
    this.mostStates = mostStates;
    this.left = work;
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

  /** For a plan with which others are only compared. */
  public static Effort forPlanBeside(int mostStates) {
    return new Effort(mostStates, FOR_PLAN_BESIDE);
  }

  public int mostStates() {
    return mostStates;
  }

  /** Actions were looked at so often. */
  public void spend(long looks) {
    left -= looks;
  }

  public boolean isSpent() {
    return left < 0;
  }
}
