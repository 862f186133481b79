package org.maestro.device.tasks;

import java.util.LinkedHashMap;
import java.util.Map;
import org.maestro.hal.Ear;
import org.maestro.hal.Hypothesis;
import org.maestro.rats.member.Execution;

/**
 * Listens until ended: silence establishes, and each hypothesis of what is said is an observation,
 * whole in itself (ADE, 4; A51).
 */
final class ListenTask extends DeviceProcedure {

  private static final double SECONDS = 0.1;

  private final FeatureContext context;
  private final Ear ear;

  ListenTask(FeatureContext context) {
    this.context = context;
    this.ear = context.driver(Ear.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Course course = new Course(execution);
    course.stop = ear.listen(course);
    report(context.feature(), execution, values(Hypothesis.SILENCE), true);
  }

  /** One call that listens. */
  private final class Course implements Ear.Listener {
    private final Execution execution;
    private Runnable stop = () -> {};

    Course(Execution execution) {
      this.execution = execution;
    }

    @Override
    public void heard(Hypothesis hypothesis) {
      if (execution.ended()) {
        stop.run();
      } else {
        report(context.feature(), execution, values(hypothesis), false);
      }
    }

    @Override
    public void failed(String reason) {
      stop.run();
      if (!execution.ended()) {
        execution.fail(FeatureContext.broken(reason));
      }
    }
  }

  private static Map<String, Object> values(Hypothesis hypothesis) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("sentence", hypothesis.sentence());
    values.put("speaker", hypothesis.speaker());
    values.put("words", String.join(" ", hypothesis.words()));
    values.put("stable", hypothesis.stable());
    values.put("confidence", hypothesis.confidence());
    values.put("alternatives", hypothesis.alternatives());
    values.put("over", hypothesis.over());
    return values;
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
