package org.maestro.knowledge.habits;

import java.util.List;

/** A memory of what was counted. */
public interface HabitLog {

  /** Keeps nothing beyond the end of the platform. */
  HabitLog NONE =
      new HabitLog() {
        @Override
        public List<String> lines() {
          return List.of();
        }

        @Override
        public void add(String line) {
          // It is forgotten with the platform.
        }
      };

  /** What was kept, oldest first. */
  List<String> lines();

  void add(String line);
}
