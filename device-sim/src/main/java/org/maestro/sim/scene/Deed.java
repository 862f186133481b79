package org.maestro.sim.scene;

import java.util.List;

/**
 * Faults and deeds that can happen to a world while it runs: the words of {@code scene:fault}, and
 * of {@link ScriptedFault} in Java. After each word come its numbers or its name.
 *
 * <table>
 * <caption>Faults</caption>
 * <tr><th>what</th><th>happens to</th><th>word and numbers</th></tr>
 * <tr><td>dies, gets power back</td><td>a device</td><td>{@code die}, {@code revive}</td></tr>
 * <tr><td>every command fails, no longer</td><td>a device</td><td>{@code break}, {@code repair}</td></tr>
 * <tr><td>does nothing for some seconds</td><td>a device</td><td>{@code freeze 20}</td></tr>
 * <tr><td>measures so many times the truth</td><td>a sensor</td><td>{@code lie 1.5}</td></tr>
 * <tr><td>measures by a share more every hour</td><td>a sensor</td><td>{@code drift 0.1}</td></tr>
 * <tr><td>wheels lose a share of their way</td><td>a robot</td><td>{@code slip 0.3}</td></tr>
 * <tr><td>lets go of what it holds</td><td>a robot</td><td>{@code drop}</td></tr>
 * <tr><td>its battery holds so much still</td><td>a robot</td><td>{@code charge 0.02}</td></tr>
 * <tr><td>gives a share of its light</td><td>a lamp</td><td>{@code weaken 0.5}</td></tr>
 * <tr><td>messages get lost, a share of them</td><td>a device</td><td>{@code lose 0.2}</td></tr>
 * <tr><td>messages take seconds longer</td><td>a device</td><td>{@code delay 2}</td></tr>
 * <tr><td>messages come twice, a share of them</td><td>a device</td><td>{@code duplicate 0.5}</td></tr>
 * <tr><td>is cut off, comes back</td><td>a device, or the home: its broker</td><td>{@code offline},
 *     {@code online}</td></tr>
 * <tr><td>goes dark: lamps without power</td><td>a zone</td><td>{@code dark}</td></tr>
 * <tr><td>has so much light besides; lux</td><td>a zone</td><td>{@code ambient 40}</td></tr>
 * <tr><td>clouds hide a share of the sky</td><td>the home</td><td>{@code clouds 0.7}</td></tr>
 * <tr><td>the sun comes out</td><td>the home</td><td>{@code sun}</td></tr>
 * <tr><td>walks there: x and y</td><td>a thing or person</td><td>{@code walk 1 2}</td></tr>
 * <tr><td>stands elsewhere: x and y</td><td>a thing or person</td><td>{@code move 1 2}</td></tr>
 * <tr><td>stands in a door</td><td>a thing or person</td><td>{@code block door-ab}</td></tr>
 * <tr><td>is put into a cupboard, taken out</td><td>a thing</td><td>{@code hide}, {@code show}</td></tr>
 * <tr><td>opens, closes</td><td>a door</td><td>{@code open}, {@code close}</td></tr>
 * </table>
 *
 * <p>A link that is bad ({@code lose}, {@code delay}, {@code duplicate}) is good again with 0.
 */
public enum Deed {
  DIE(Subject.DEVICE),
  REVIVE(Subject.DEVICE),
  BREAK(Subject.DEVICE),
  REPAIR(Subject.DEVICE),
  FREEZE(Subject.DEVICE, Argument.NUMBER),
  LIE(Subject.DEVICE, Argument.NUMBER),
  DRIFT(Subject.DEVICE, Argument.ANY_NUMBER),
  SLIP(Subject.ROBOT, Argument.SHARE),
  DROP(Subject.ROBOT),
  CHARGE(Subject.ROBOT, Argument.SHARE),
  WEAKEN(Subject.LAMP, Argument.NUMBER),
  LOSE(Subject.DEVICE, Argument.SHARE),
  DELAY(Subject.DEVICE, Argument.NUMBER),
  DUPLICATE(Subject.DEVICE, Argument.SHARE),
  OFFLINE(Subject.DEVICE_OR_HOME),
  ONLINE(Subject.DEVICE_OR_HOME),
  DARK(Subject.ZONE),
  AMBIENT(Subject.ZONE, Argument.NUMBER),
  CLOUDS(Subject.HOME, Argument.SHARE),
  SUN(Subject.HOME),
  WALK(Subject.THING, Argument.ANY_NUMBER, Argument.ANY_NUMBER),
  MOVE(Subject.THING, Argument.ANY_NUMBER, Argument.ANY_NUMBER),
  BLOCK(Subject.THING, Argument.NAME),
  HIDE(Subject.THING),
  SHOW(Subject.THING),
  OPEN(Subject.DOOR),
  CLOSE(Subject.DOOR);

  private final Subject subject;

  /** Made by {@code List.of}, which nobody can change. */
  @SuppressWarnings("ImmutableEnumChecker")
  private final List<Argument> arguments;

  Deed(Subject subject, Argument... arguments) {
    this.subject = subject;
    this.arguments = List.of(arguments);
  }

  /** To what it can happen. */
  public enum Subject {
    DEVICE("a device"),
    ROBOT("a robot"),
    LAMP("a lamp"),
    DEVICE_OR_HOME("a device, or for the home itself"),
    ZONE("a zone"),
    HOME("the home itself"),
    THING("a thing or person that is in the world"),
    DOOR("a door");

    private final String words;

    Subject(String words) {
      this.words = words;
    }

    public String words() {
      return words;
    }
  }

  /** A word's argument: a name, any number, a number from 0 on, or a share. */
  enum Argument {
    NAME,
    ANY_NUMBER,
    NUMBER,
    SHARE
  }

  public Subject subject() {
    return subject;
  }

  List<Argument> arguments() {
    return arguments;
  }
}
