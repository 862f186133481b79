package org.maestro.device.tasks;

import java.util.Optional;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.hal.Target;

/**
 * A look that takes no more frames than its verdict needs: some at a time, until they show the
 * thing, until missing it is next to impossible, or until there are as many as a look has at most.
 * Clock thread only.
 */
final class Burst {

  /** At a time; in good light they suffice. */
  static final int PART = 5;

  static final int MOST = 15;

  private final Camera camera;
  private final Target target;
  private final Camera.Listener listener;

  private Burst(Camera camera, Target target, Camera.Listener listener) {
    this.camera = camera;
    this.target = target;
    this.listener = listener;
  }

  /**
   * @param listener told once, of all frames together
   */
  static void take(Camera camera, Target target, Camera.Listener listener) {
    new Burst(camera, target, listener).more(Optional.empty());
  }

  private void more(Optional<Camera.Look> before) {
    camera.look(
        target,
        PART,
        new Camera.Listener() {
          @Override
          public void looked(Camera.Look part) {
            Camera.Look all = before.map(look -> both(look, part)).orElse(part);
            if (all.frames() >= MOST || isCertain(all)) {
              listener.looked(all);
            } else {
              more(Optional.of(all));
            }
          }

          @Override
          public void failed(String reason) {
            listener.failed(reason);
          }

          @Override
          public void doubted(String reason) {
            listener.doubted(reason);
          }
        });
  }

  /** It is there, it is not there, or something is over-lit: more frames would not change that. */
  private boolean isCertain(Camera.Look look) {
    SightVerdict verdict = SightVerdict.of(look, camera);
    return verdict.found() || verdict.unfit().isEmpty() || !look.glaring().isEmpty();
  }

  /** The place is that of the part that shows the thing oftener: the other may show another. */
  private static Camera.Look both(Camera.Look before, Camera.Look part) {
    Optional<Position> position =
        part.detections() > before.detections() ? part.position() : before.position();
    return new Camera.Look(
        before.frames() + part.frames(),
        before.detections() + part.detections(),
        position.or(part::position),
        part.areas(),
        part.glaring());
  }
}
