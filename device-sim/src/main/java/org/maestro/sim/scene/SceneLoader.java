package org.maestro.sim.scene;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.hal.Position;
import org.maestro.hal.sight.Paint;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Nearest;
import org.maestro.sl.SlPrinter;

/**
 * Reads scenes in Turtle: words of {@code scene:} about things of one home. A fault is a {@link
 * SimulationException}; all of them are told by {@link #check}.
 */
public final class SceneLoader {

  public static final String NAMESPACE = "https://w3id.org/maestro/scene#";

  private static final List<String> WORDS =
      List.of(
          "position",
          "hidden",
          "radius",
          "mass",
          "level",
          "strength",
          "ambientLux",
          "open",
          "opening",
          "dead",
          "speed",
          "payload",
          "diesWhen",
          "colour",
          "charge",
          "charges",
          "celsius",
          "fault",
          "walks",
          "roams",
          "says",
          "state");

  private final SceneText text;

  private SceneLoader(SceneText text) {
    this.text = text;
  }

  /**
   * @param name for messages, such as the file's name
   * @throws SimulationException when it is no Turtle, or speaks of what the home does not have or
   *     in words that no scene knows
   */
  public static Scene load(String name, InputStream turtle, Home home) {
    return load(name, text(name, turtle), home, List.of());
  }

  /**
   * Reads what a scene of several homes says of one of them: what it says of things that the others
   * alone have is left out.
   *
   * @param name for messages, such as the file's name
   * @throws SimulationException when it is no Turtle, or speaks of what none of the homes has or in
   *     words that no scene knows
   */
  public static Scene load(String name, String turtle, Home home, Collection<Home> others) {
    SceneText text = new SceneText(name, turtle, home, others);
    Scene scene = new SceneLoader(text).read(name);
    if (!text.faults().isEmpty()) {
      Fault first = text.faults().get(0);
      throw new SimulationException(
          "The scene %s%s %s; %s."
              .formatted(
                  name,
                  first.line() > 0 ? ", line " + first.line() + "," : "",
                  first.subject().equals("the text")
                      ? "is no Turtle: " + first.problem()
                      : first.problem(),
                  first.cure()));
    }
    return scene;
  }

  /** Every fault of a scene, and what in it is hardly meant so, each with its line. */
  public static CheckedScene check(String name, String turtle, Home home) {
    SceneText text = new SceneText(name, turtle, home);
    Scene scene = new SceneLoader(text).read(name);
    SceneDoubts doubts = new SceneDoubts(text, scene, home);
    if (!text.faults().isEmpty()) {
      return new CheckedScene(text.faults(), List.of());
    }
    return new CheckedScene(doubts.robotsNowhere(), doubts.found());
  }

  private static String text(String name, InputStream turtle) {
    try {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new SimulationException("The scene " + name + " cannot be read.", e);
    }
  }

  /** What can be read; the rest becomes faults of the text. */
  private Scene read(String name) {
    Map<String, Map<String, String>> words = new TreeMap<>();
    text.words().forEach((thing, said) -> words.put(thing, new TreeMap<>(said)));
    Map<String, List<ScriptedFault>> faults = new TreeMap<>();
    Map<String, List<Stop>> walks = new TreeMap<>();
    Map<String, Double> roams = new TreeMap<>();
    Map<String, List<Saying>> sayings = new TreeMap<>();
    words.forEach((thing, said) -> attempt(() -> roams(thing, said, roams)));
    words.forEach((thing, said) -> attempt(() -> sayings(thing, said, sayings)));
    words.forEach((thing, said) -> attempt(() -> course(thing, said, faults, walks)));
    List<SceneSky> sky = new ArrayList<>();
    Optional.ofNullable(words.remove(SceneText.HOME))
        .filter(said -> !said.isEmpty())
        .ifPresent(
            said ->
                attempt(
                    () ->
                        sky.add(
                            SkyReader.read(
                                said, (word, what) -> fault(SceneText.HOME, word, what)))));
    Map<String, Scene.Entry> entries = new LinkedHashMap<>();
    Map<String, Double> openings = new TreeMap<>();
    words.forEach(
        (thing, said) ->
            attempt(
                () -> {
                  number(thing, "opening", said.remove("opening"), 1)
                      .ifPresent(opening -> openings.put(thing, opening));
                  entries.put(thing, entry(thing, said));
                }));
    return new Scene(
        name,
        entries,
        sky.stream().findFirst(),
        openings,
        new Course(faults, walks, roams, sayings),
        text.states());
  }

  private void attempt(Runnable reading) {
    try {
      reading.run();
    } catch (Unreadable e) {
      text.faults().add(e.fault);
    }
  }

  /** Ends the reading of what is said of one thing. */
  private static final class Unreadable extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient Fault fault;

    Unreadable(Fault fault) {
      super(fault.toString());
      this.fault = fault;
    }
  }

  private void course(
      String thing,
      Map<String, String> said,
      Map<String, List<ScriptedFault>> faults,
      Map<String, List<Stop>> walks) {
    String scripted = said.remove("fault");
    String walk = said.remove("walks");
    try {
      if (scripted != null) {
        faults.put(thing, Arrays.stream(scripted.split(";")).map(ScriptedFault::parse).toList());
      }
      if (walk != null) {
        walks.put(thing, corners(walk));
      }
    } catch (IllegalArgumentException e) {
      throw fault(
          thing,
          scripted == null ? "walks" : "fault",
          "does not say what happens to "
              + (thing.isEmpty() ? "the home" : thing)
              + ": "
              + e.getMessage());
    }
    if (walk != null && !said.containsKey("position")) {
      throw fault(
          thing,
          "walks",
          "lets " + thing + " walk, but does not say from where; add a scene:position");
    }
  }

  private void roams(String thing, Map<String, String> said, Map<String, Double> roams) {
    if (thing.equals(SceneText.HOME)) {
      return;
    }
    OptionalDouble seconds = number(thing, "roams", said.remove("roams"), 86_400);
    if (seconds.isPresent() && said.containsKey("walks")) {
      throw fault(
          thing,
          "roams",
          "lets %s walk a round and go about; leave out scene:walks or scene:roams"
              .formatted(thing));
    }
    if (seconds.isPresent() && seconds.getAsDouble() < 1) {
      throw fault(
          thing, "roams", "lets %s stay in no place; write 1 second or more".formatted(thing));
    }
    if (seconds.isPresent() && !said.containsKey("position")) {
      throw fault(
          thing,
          "roams",
          "lets " + thing + " go about, but does not say from where; add a scene:position");
    }
    seconds.ifPresent(mean -> roams.put(thing, mean));
  }

  private void sayings(String thing, Map<String, String> said, Map<String, List<Saying>> sayings) {
    String says = said.remove("says");
    if (says == null) {
      return;
    }
    if (!said.containsKey("position")) {
      throw fault(
          thing, "says", "lets " + thing + " speak, but does not say where; add a scene:position");
    }
    try {
      sayings.put(thing, Arrays.stream(says.split(";")).map(Saying::parse).toList());
    } catch (IllegalArgumentException e) {
      throw fault(
          thing,
          "says",
          "does not say what %s says: %s"
              .formatted(thing, String.valueOf(e.getMessage()).replaceAll("\\.$", "")));
    }
  }

  private static List<Stop> corners(String walk) {
    return Arrays.stream(walk.split(",")).map(Stop::parse).toList();
  }

  private Scene.Entry entry(String thing, Map<String, String> said) {
    Map<String, String> left = new TreeMap<>(said);
    Scene.Entry entry =
        new Scene.Entry(
            Optional.ofNullable(left.remove("position")).map(text -> position(thing, text)),
            truth(thing, "hidden", left.remove("hidden")).orElse(false),
            number(thing, "radius", left.remove("radius"), 10),
            number(thing, "mass", left.remove("mass"), Double.MAX_VALUE),
            number(thing, "level", left.remove("level"), 1),
            number(thing, "strength", left.remove("strength"), 10),
            number(thing, "ambientLux", left.remove("ambientLux"), 200_000),
            truth(thing, "open", left.remove("open")),
            truth(thing, "dead", left.remove("dead")).orElse(false),
            number(thing, "speed", left.remove("speed"), 10),
            number(thing, "payload", left.remove("payload"), 1_000),
            Optional.ofNullable(left.remove("diesWhen")).map(text -> kind(thing, text)),
            Optional.ofNullable(left.remove("colour")).map(text -> paint(thing, text)),
            number(thing, "charge", left.remove("charge"), 1),
            truth(thing, "charges", left.remove("charges")).orElse(false),
            number(thing, "celsius", left.remove("celsius"), 60));
    if (!left.isEmpty()) {
      String unknown = new TreeSet<>(left.keySet()).first();
      throw fault(
          thing,
          unknown,
          "says scene:%s of %s; %s"
              .formatted(
                  unknown,
                  thing,
                  Nearest.cure(
                      unknown,
                      WORDS,
                      word -> "scene:" + word,
                      "known are " + String.join(", ", WORDS))));
    }
    return entry;
  }

  private Position position(String thing, String text) {
    try {
      Pose pose = Pose.parse(text);
      return new Position(pose.x(), pose.y(), pose.z());
    } catch (IllegalArgumentException e) {
      throw fault(
          thing,
          "position",
          "gives %s a scene:position that is none: %s; write x, y and z in metres, such as \"1 2 0\""
              .formatted(thing, String.valueOf(e.getMessage()).replaceAll("\\.$", "")));
    }
  }

  private Paint paint(String thing, String text) {
    return Paint.parse(text)
        .orElseThrow(
            () ->
                fault(
                    thing,
                    "colour",
                    "gives %s the scene:colour \"%s\"; write a name such as red, or #a03020"
                        .formatted(thing, text)));
  }

  private OptionalDouble number(String thing, String word, String text, double greatest) {
    if (text == null) {
      return OptionalDouble.empty();
    }
    try {
      double number = Double.parseDouble(text);
      if (number >= 0 && number <= greatest) {
        return OptionalDouble.of(number);
      }
    } catch (NumberFormatException e) {
      throw fault(
          thing,
          word,
          "gives %s the scene:%s \"%s\", which is no number; write one"
              .formatted(thing, word, text));
    }
    String cure =
        greatest == Double.MAX_VALUE
            ? "write 0 or more"
            : "it lies between 0 and " + SlPrinter.print(greatest);
    throw fault(thing, word, "gives %s the scene:%s %s; %s".formatted(thing, word, text, cure));
  }

  private Optional<Boolean> truth(String thing, String word, String text) {
    if (text == null) {
      return Optional.empty();
    }
    if (!text.equals("true") && !text.equals("false")) {
      throw fault(
          thing,
          word,
          "gives " + thing + " the scene:" + word + " \"" + text + "\"; it is true or false");
    }
    return Optional.of(text.equals("true"));
  }

  private WorldEvent.Kind kind(String thing, String text) {
    return Arrays.stream(WorldEvent.Kind.values())
        .filter(kind -> word(kind).equals(text))
        .findFirst()
        .orElseThrow(
            () ->
                fault(
                    thing,
                    "diesWhen",
                    "says that "
                        + thing
                        + " dies upon \""
                        + text
                        + "\"; known are "
                        + Arrays.stream(WorldEvent.Kind.values())
                            .map(SceneLoader::word)
                            .collect(Collectors.joining(", "))));
  }

  private static String word(WorldEvent.Kind kind) {
    return kind.name().toLowerCase(Locale.ROOT);
  }

  private RuntimeException fault(String thing, String word, String what) {
    return new Unreadable(text.told(text.line(thing, word), what));
  }
}
