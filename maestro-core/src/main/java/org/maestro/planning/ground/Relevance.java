package org.maestro.planning.ground;

/** Which ground atoms and functions may matter for a goal. */
interface Relevance {
  /** All of them, where the question is what can be reached at all. */
  Relevance OF_ALL =
      new Relevance() {
        @Override
        public boolean mayHaveToHold(int symbol, int[] objects) {
          return true;
        }

        @Override
        public boolean mayHaveToLack(int symbol, int[] objects) {
          return true;
        }

        @Override
        public boolean mayHaveToChange(int function, int[] objects) {
          return true;
        }
      };

  /** Whether it may matter that the ground atom holds. */
  boolean mayHaveToHold(int symbol, int[] objects);

  /** Whether it may matter that the ground atom does not hold. */
  boolean mayHaveToLack(int symbol, int[] objects);

  /** Whether the value of the ground function may matter. */
  boolean mayHaveToChange(int function, int[] objects);
}
