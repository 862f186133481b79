package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.sl.Term;

/** What is made of what comes beside a call's result. */
class CallReporterTest {
  private final List<String> heard = new ArrayList<>();
  private final CallReporter reporter =
      new CallReporter(
          Runnable::run,
          fact -> fact,
          new CallReporter.Listener() {
            @Override
            public void reported(Outcome outcome, ActionDispatcher.Report report) {
              heard.add("reported " + outcome);
            }

            @Override
            public void learnt(Map<String, Term> outputs) {
              heard.add("learnt " + outputs.keySet());
            }

            @Override
            public void alerted(String message) {
              heard.add("alerted " + message);
            }

            @Override
            public void over() {
              heard.add("over");
            }
          });

  @Test
  void anAlarmIsToldAndTeachesNothing() {
    reporter.observed(observation("watch", Map.of("lux", 80)));
    reporter.observed(
        observation(ReservedFeature.ALERT, Map.of("message", "The arm cannot be folded.")));
    assertThat(heard).containsExactly("learnt [lux]", "alerted The arm cannot be folded.");
  }

  private static Observation observation(String feature, Map<String, Object> values) {
    return new Observation("c1", "rose", feature, values);
  }
}
