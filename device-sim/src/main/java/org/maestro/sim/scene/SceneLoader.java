package org.maestro.sim.scene;

import java.io.InputStream;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.apache.jena.rdf.model.Model;
import org.apache.jena.rdf.model.ModelFactory;
import org.apache.jena.rdf.model.Statement;
import org.apache.jena.riot.Lang;
import org.apache.jena.riot.RDFParser;
import org.apache.jena.riot.RiotException;
import org.apache.jena.riot.system.ErrorHandlerFactory;
import org.apache.jena.sys.JenaSystem;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Home;

/**
 * Reads scenes in Turtle: words of {@code scene:} about things of one home. Every fault is one
 * {@link SimulationException}.
 */
public final class SceneLoader {

  public static final String NAMESPACE = "https://w3id.org/maestro/scene#";

  /** Of what is said of the home itself; no thing has this name. */
  private static final String HOME = "";

  private final String name;
  private final Home home;
  private final Map<String, Map<String, String>> words = new TreeMap<>();

  private SceneLoader(String name, Home home) {
    this.name = name;
    this.home = home;
  }

  /**
   * @param name for messages, such as the file's name
   * @throws SimulationException when it is no Turtle, or speaks of what the home does not have or
   *     in words that no scene knows
   */
  public static Scene load(String name, InputStream turtle, Home home) {
    SceneLoader loader = new SceneLoader(name, home);
    loader.read(turtle);
    Map<String, List<ScriptedFault>> faults = new TreeMap<>();
    Map<String, List<Point2>> walks = new TreeMap<>();
    loader.words.forEach((thing, said) -> loader.course(thing, said, faults, walks));
    Optional<SceneSky> sky =
        Optional.ofNullable(loader.words.remove(HOME))
            .filter(said -> !said.isEmpty())
            .map(said -> SkyReader.read(said, loader::fault));
    Map<String, Scene.Entry> entries = new LinkedHashMap<>();
    Map<String, Double> openings = new TreeMap<>();
    loader.words.forEach(
        (thing, said) -> {
          loader
              .number(thing, "opening", said.remove("opening"), 1)
              .ifPresent(opening -> openings.put(thing, opening));
          entries.put(thing, loader.entry(thing, said));
        });
    return new Scene(name, entries, sky, openings, new Course(faults, walks));
  }

  private void read(InputStream turtle) {
    JenaSystem.init();
    Model model = ModelFactory.createDefaultModel();
    try {
      RDFParser.source(turtle)
          .lang(Lang.TURTLE)
          .base(home.iri())
          .errorHandler(ErrorHandlerFactory.errorHandlerStrictNoLogging)
          .parse(model);
    } catch (RiotException e) {
      throw new SimulationException("The scene " + name + " is no Turtle: " + e.getMessage(), e);
    }
    for (Statement statement : model.listStatements().toList()) {
      String predicate = statement.getPredicate().getURI();
      if (!predicate.startsWith(NAMESPACE)) {
        throw fault("uses the property <" + predicate + ">; a scene knows words of scene: only");
      }
      if (!statement.getObject().isLiteral()) {
        throw fault("gives " + predicate + " a value that is no literal");
      }
      String thing = thing(statement.getSubject().toString());
      String word = predicate.substring(NAMESPACE.length());
      String former =
          words
              .computeIfAbsent(thing, key -> new TreeMap<>())
              .put(word, statement.getLiteral().getLexicalForm());
      if (former != null) {
        throw fault("gives " + thing + " two values of scene:" + word);
      }
    }
  }

  private void course(
      String thing,
      Map<String, String> said,
      Map<String, List<ScriptedFault>> faults,
      Map<String, List<Point2>> walks) {
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
          "does not say what happens to "
              + (thing.isEmpty() ? "the home" : thing)
              + ": "
              + e.getMessage());
    }
    if (walk != null && !said.containsKey("position")) {
      throw fault("lets " + thing + " walk, but does not say from where; add a scene:position");
    }
  }

  private static List<Point2> corners(String walk) {
    return Arrays.stream(walk.split(","))
        .map(corner -> Pose.parse(corner.strip() + " 0").floor())
        .toList();
  }

  private String thing(String iri) {
    if (iri.equals(home.iri())) {
      return HOME;
    }
    String local = iri.substring(Math.max(iri.lastIndexOf('#'), iri.lastIndexOf('/')) + 1);
    if (!home.individuals().containsKey(local)) {
      throw fault(
          "speaks of "
              + local
              + ", which the home does not have; it has "
              + String.join(", ", home.individuals().keySet()));
    }
    return local;
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
            truth(thing, "charges", left.remove("charges")).orElse(false));
    if (!left.isEmpty()) {
      throw fault(
          "says scene:"
              + new TreeSet<>(left.keySet()).first()
              + " of "
              + thing
              + "; known are position, hidden, radius, mass, level, strength, ambientLux, open,"
              + " opening, dead, speed, payload, diesWhen, colour, charge, charges, fault, walks");
    }
    return entry;
  }

  private Position position(String thing, String text) {
    try {
      Pose pose = Pose.parse(text);
      return new Position(pose.x(), pose.y(), pose.z());
    } catch (IllegalArgumentException e) {
      throw fault("gives " + thing + " a scene:position that is none: " + e.getMessage());
    }
  }

  private Paint paint(String thing, String text) {
    return Paint.parse(text)
        .orElseThrow(
            () ->
                fault(
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
          "gives " + thing + " the scene:" + word + " \"" + text + "\", which is no number");
    }
    throw fault(
        "gives "
            + thing
            + " the scene:"
            + word
            + " "
            + text
            + "; it lies between 0 and "
            + greatest);
  }

  private Optional<Boolean> truth(String thing, String word, String text) {
    if (text == null) {
      return Optional.empty();
    }
    if (!text.equals("true") && !text.equals("false")) {
      throw fault(
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

  private SimulationException fault(String what) {
    return new SimulationException("The scene " + name + " " + what + ".");
  }
}
