package org.maestro.hal.ros;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;

/**
 * A look under way: the frames that show the thing, in the place where the surest of them shows it.
 * Clock thread only.
 */
final class Looking {

  /** What is farther off is another of its kind. */
  private static final double SAME_PLACE_METRES = 0.3;

  private final String thing;
  private final int wanted;
  private final Camera.Listener listener;
  private final List<RosDetections.Detection> shown = new ArrayList<>();
  private int frames;

  Looking(String thing, int wanted, Camera.Listener listener) {
    this.thing = thing;
    this.wanted = wanted;
    this.listener = listener;
  }

  Camera.Listener listener() {
    return listener;
  }

  void add(List<RosDetections.Detection> frame) {
    frames++;
    Optional<RosDetections.Detection> surest = surest();
    frame.stream()
        .filter(detection -> detection.thing().equals(thing))
        .min(
            Comparator.comparingDouble(
                detection ->
                    surest
                        .map(before -> before.place().distance(detection.place()))
                        .orElse(1 - detection.score())))
        .ifPresent(shown::add);
  }

  boolean isOver(int agreeing, int most) {
    return frames >= wanted && (inOnePlace().size() >= agreeing || frames >= most);
  }

  /** Says where it is, or that it cannot say. */
  void tell(int agreeing) {
    List<RosDetections.Detection> same = inOnePlace();
    if (same.size() >= agreeing) {
      listener.looked(new Camera.Look(frames, same.size(), Optional.of(mean(same)), List.of()));
    } else {
      listener.failed(
          "%d of %d frames show %s in one place, which does not say whether it is there."
              .formatted(same.size(), frames, thing));
    }
  }

  private Optional<RosDetections.Detection> surest() {
    return shown.stream().max(Comparator.comparingDouble(RosDetections.Detection::score));
  }

  private List<RosDetections.Detection> inOnePlace() {
    return surest()
        .map(
            best ->
                shown.stream()
                    .filter(other -> other.place().distance(best.place()) <= SAME_PLACE_METRES)
                    .toList())
        .orElse(List.of());
  }

  private static Position mean(List<RosDetections.Detection> all) {
    return new Position(
        all.stream().mapToDouble(one -> one.place().x()).average().orElseThrow(),
        all.stream().mapToDouble(one -> one.place().y()).average().orElseThrow(),
        all.stream().mapToDouble(one -> one.place().z()).average().orElseThrow());
  }
}
