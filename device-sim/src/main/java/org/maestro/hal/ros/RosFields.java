package org.maestro.hal.ros;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import org.maestro.hal.Position;
import org.maestro.hal.wheels.Stance;
import org.maestro.ontology.floor.Point2;

/**
 * The fields of a message as rosbridge writes them in JSON, read with a plain word about what is
 * wrong. Numbers that are none, such as NaN, are null there. Immutable.
 */
final class RosFields {

  /** Of a quaternion's length; rounding does less. */
  private static final double QUATERNION_ERROR = 0.1;

  private final JsonNode node;
  private final String path;

  RosFields(JsonNode message) {
    this(message, "");
  }

  private RosFields(JsonNode node, String path) {
    this.node = node;
    this.path = path;
  }

  /**
   * The fields below a field.
   *
   * @throws RosMessageException when there is no such field, or none below it
   */
  RosFields in(String field) {
    RosFields below = below(field);
    if (!below.node.isObject()) {
      throw new RosMessageException(below.path + " is missing");
    }
    return below;
  }

  /** Whether there are fields below a field. */
  boolean has(String field) {
    return node.path(field).isObject();
  }

  /** The elements of a field that is a sequence, each with fields of its own. */
  List<RosFields> each(String field) {
    RosFields sequence = below(field);
    if (!sequence.node.isArray()) {
      throw new RosMessageException(sequence.path + " is no sequence");
    }
    List<RosFields> elements = new ArrayList<>();
    for (JsonNode element : sequence.node) {
      elements.add(new RosFields(element, "%s[%d]".formatted(sequence.path, elements.size())));
    }
    return elements;
  }

  double number(String field) {
    RosFields number = below(field);
    double value = number.node.asDouble();
    if (!number.node.isNumber() || !Double.isFinite(value)) {
      throw new RosMessageException(number.path + " is no number");
    }
    return value;
  }

  /** A number that is not below 0. */
  double amount(String field) {
    double amount = number(field);
    if (amount < 0) {
      throw new RosMessageException(below(field).path + " is below 0");
    }
    return amount;
  }

  String text(String field) {
    RosFields text = below(field);
    if (!text.node.isTextual()) {
      throw new RosMessageException(text.path + " is no text");
    }
    return text.node.asText();
  }

  /** A name, which older messages have as a number. */
  String name(String field) {
    RosFields name = below(field);
    if (!name.node.isTextual() && !name.node.isIntegralNumber()) {
      throw new RosMessageException(name.path + " is no name");
    }
    return name.node.asText();
  }

  /** Of a geometry_msgs/Point; metres. */
  Position position() {
    return new Position(number("x"), number("y"), number("z"));
  }

  /** Of a geometry_msgs/Pose on the floor. */
  Stance stance() {
    Position place = in("position").position();
    return new Stance(new Point2(place.x(), place.y()), in("orientation").yaw());
  }

  private double yaw() {
    double x = number("x");
    double y = number("y");
    double z = number("z");
    double w = number("w");
    if (Math.abs(Math.sqrt(x * x + y * y + z * z + w * w) - 1) > QUATERNION_ERROR) {
      throw new RosMessageException(path + " is no quaternion of length 1");
    }
    return Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  }

  private RosFields below(String field) {
    return new RosFields(node.path(field), path.isEmpty() ? field : path + "." + field);
  }
}
