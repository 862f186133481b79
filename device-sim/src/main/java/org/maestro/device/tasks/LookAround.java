package org.maestro.device.tasks;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.hal.Area;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.rats.member.Execution;

/**
 * Turns around on the spot once and looks for an object. Not found is said with the share of the
 * area's floor that was in view, and only when the light allows to say so.
 */
final class LookAround extends DeviceProcedure {

  /** In each direction. */
  private static final int FRAMES = 15;

  /** Turning, and half a second in each of some eight directions. */
  private static final double SECONDS = 8;

  private static final double JOULES_PER_SECOND = 20;

  private final FeatureContext context;
  private final Camera camera;
  private final Robot robot;

  LookAround(FeatureContext context) {
    this.context = context;
    this.camera = context.driver(Camera.class);
    this.robot = new Robot(context);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer object = parameters.pointer("object");
    Optional<Area> here =
        robot.surroundings().areas().stream()
            .filter(area -> area.outline().contains(robot.base().position()))
            .findFirst();
    if (here.isEmpty()) {
      execution.fail(
          FeatureContext.unmet("It stands in no area of its map.", "drive it into one", List.of()));
      return;
    }
    camera.look(
        object.target(),
        FRAMES,
        new Camera.Listener() {
          @Override
          public void looked(Camera.Look look) {
            judge(execution, parameters, look, here.get());
          }

          @Override
          public void failed(String reason) {
            execution.fail(FeatureContext.broken(reason));
          }

          @Override
          public void doubted(String reason) {
            execution.fail(SightVerdict.doubt(reason));
          }
        });
  }

  private void judge(Execution execution, CallParameters parameters, Camera.Look look, Area here) {
    SightVerdict verdict = SightVerdict.of(look, camera);
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("covered", Numbers.tenths(1000 * camera.shareInView(here.name())) / 1000);
    if (verdict.found()) {
      Position position = look.position().orElseThrow();
      values.put("found", true);
      values.put("pose", List.of(position.x(), position.y(), position.z()));
      execution.succeed(values);
    } else if (verdict.unfit().isEmpty()) {
      values.put("found", false);
      execution.succeed(values);
    } else {
      execution.fail(verdict.refusal(context, parameters, camera));
    }
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, SECONDS * JOULES_PER_SECOND);
  }
}
