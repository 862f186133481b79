package org.maestro.hal.ros;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.hal.Position;

/**
 * The reading of vision_msgs/Detection3DArray: what a detector takes the things in one frame for.
 * Both forms are read, that in which a hypothesis has a name, and the older one in which its number
 * stands beside it. Immutable.
 *
 * @param frame in which positions are to be, the home's
 * @param thingByClass what the detector's classes are in the home, where names differ
 */
record RosDetections(String frame, Map<String, String> thingByClass) {

  /** Below this a detector does not say that it is so; assumed. */
  private static final double LEAST_SCORE = 0.5;

  RosDetections {
    thingByClass = Map.copyOf(thingByClass);
  }

  /**
   * A thing that one frame shows.
   *
   * @param score 0 to 1
   */
  record Detection(String thing, double score, Position place) {}

  /**
   * @throws RosMessageException when the message is no such, or its positions are in another frame
   */
  List<Detection> read(RosFields message) {
    String told = message.in("header").text("frame_id");
    if (!told.equals(frame) && !told.equals("/" + frame)) {
      throw new RosMessageException(
          "header.frame_id is \"%s\", and the home's frame is %s; have its positions transformed"
              .formatted(told, frame));
    }
    List<Detection> shown = new ArrayList<>();
    for (RosFields detection : message.each("detections")) {
      likeliest(detection.each("results"))
          .filter(result -> result.score() >= LEAST_SCORE)
          .ifPresent(shown::add);
    }
    return List.copyOf(shown);
  }

  private Optional<Detection> likeliest(List<RosFields> results) {
    return results.stream().map(this::detection).max(Comparator.comparing(Detection::score));
  }

  private Detection detection(RosFields result) {
    boolean isNamed = result.has("hypothesis");
    RosFields hypothesis = isNamed ? result.in("hypothesis") : result;
    String type = hypothesis.name(isNamed ? "class_id" : "id");
    return new Detection(
        thingByClass.getOrDefault(type, type),
        hypothesis.number("score"),
        result.in("pose").in("pose").in("position").position());
  }
}
