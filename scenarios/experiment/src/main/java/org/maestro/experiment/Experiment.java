package org.maestro.experiment;

import java.util.List;
import org.maestro.experiment.running.Progress;
import org.maestro.experiment.setting.Setting;

/** One of the papers' experiments. */
public interface Experiment {

  /** As it is called on the command line. */
  String name();

  /** What it shows, half a sentence. */
  String purpose();

  /** How many runs it has unless another number is asked for. */
  int usualRuns();

  /** What can be set: each changes what runs write, be it under conditions only. */
  List<Setting> settings();

  /** Whether it can repeat its runs on the paced clock. */
  default boolean canBePaced() {
    return false;
  }

  /** Its runs, none of which is carried out yet. */
  Course<?> begin(Request request);

  /** All of its runs, and what they show. */
  default Findings carryOut(Request request, Progress progress) {
    Course<?> course = begin(request);
    course.carryOut(progress);
    return course.findings();
  }
}
