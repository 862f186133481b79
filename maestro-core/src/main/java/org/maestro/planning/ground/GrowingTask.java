package org.maestro.planning.ground;

/**
 * A ground task of which ever more is known: what can be reached cheaply is there first. For one
 * thread at a time.
 */
public interface GrowingTask {
  /** All that is there already; {@link GroundTask#unreachable} is only true when all is. */
  GroundTask task();

  /**
   * Every plan that costs less than this has all its operators there, proven.
   *
   * @return in units of the task; {@link Long#MAX_VALUE} when all are there
   */
  long beyond();

  /**
   * Goes on.
   *
   * @param cost every plan that costs no more, in units of the task, is to have its operators there
   * @throws java.util.concurrent.CancellationException when patience is over before
   */
  void grow(long cost, GroundingBudget patience);

  /** A task that is all there. */
  static GrowingTask whole(GroundTask task) {
    return new GrowingTask() {
      @Override
      public GroundTask task() {
        return task;
      }

      @Override
      public long beyond() {
        return Long.MAX_VALUE;
      }

      @Override
      public void grow(long cost, GroundingBudget patience) {
        patience.check();
      }
    };
  }
}
