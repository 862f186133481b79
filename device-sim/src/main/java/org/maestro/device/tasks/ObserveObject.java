package org.maestro.device.tasks;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.rats.member.Execution;

/**
 * Looks for an object until ended (Three-layered architecture, 4.3; M87). Found is said when
 * several frames of a burst agree; not found only when the images are bright enough everywhere in
 * what the camera covers that missing it is next to impossible. Otherwise the call fails and names
 * the light that is missing; once established it says nothing while it cannot tell.
 */
final class ObserveObject extends DeviceProcedure {

  private static final double SECONDS = 1;

  private final FeatureContext context;
  private final Camera camera;
  private final Observations observations;
  private final Duration period;

  ObserveObject(FeatureContext context, Observations observations) {
    this.context = context;
    this.camera = context.driver(Camera.class);
    this.observations = observations;
    this.period = Streams.period(context.feature());
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer object = parameters.pointer("object");
    observations.add(object.name(), execution);
    look(execution, parameters, object, true);
  }

  private void look(Execution execution, CallParameters parameters, Pointer object, boolean first) {
    if (execution.ended()) {
      return;
    }
    Duration begun = context.clock().now();
    Burst.take(
        camera,
        object.target(),
        new Camera.Listener() {
          @Override
          public void looked(Camera.Look look) {
            judge(execution, parameters, look, first);
            Streams.next(context, begun, period, () -> look(execution, parameters, object, false));
          }

          @Override
          public void failed(String reason) {
            execution.fail(FeatureContext.broken(reason));
          }

          @Override
          public void doubted(String reason) {
            if (first) {
              execution.fail(SightVerdict.doubt(reason));
            } else {
              Streams.next(
                  context, begun, period, () -> look(execution, parameters, object, false));
            }
          }
        });
  }

  private void judge(
      Execution execution, CallParameters parameters, Camera.Look look, boolean first) {
    SightVerdict verdict = SightVerdict.of(look, camera);
    if (verdict.found()) {
      Position position = look.position().orElseThrow();
      Map<String, Object> values = new LinkedHashMap<>();
      values.put("found", true);
      values.put("pose", List.of(position.x(), position.y(), position.z()));
      report(context.feature(), execution, values, first);
    } else if (verdict.unfit().isEmpty()) {
      report(context.feature(), execution, new LinkedHashMap<>(Map.of("found", false)), first);
    } else if (first) {
      execution.fail(verdict.refusal(context, parameters, camera));
    }
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
