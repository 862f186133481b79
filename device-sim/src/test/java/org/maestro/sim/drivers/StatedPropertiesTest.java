package org.maestro.sim.drivers;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.apache.jena.rdf.model.Model;
import org.apache.jena.rdf.model.ModelFactory;
import org.apache.jena.rdf.model.Resource;
import org.apache.jena.vocabulary.RDFS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.hal.Position;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.Homes;
import org.maestro.sim.Homes.Answer;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/**
 * Each property that devices of a class have, by the vocabulary, changes what a simulated one does;
 * one that only others have is refused. The classes and properties are read from the vocabulary.
 */
class StatedPropertiesTest {
  private static final String MAESTRO = "https://w3id.org/maestro#";
  private static final String DOMAIN = "https://w3id.org/maestro/domain#";

  /** Two values of each, in Turtle. */
  private static final Map<String, List<String>> VALUES =
      Map.ofEntries(
          Map.entry("maestro:pose", List.of("\"1.5 2 2.4\"", "\"6 2 2.4\"")),
          Map.entry("maestro:viewAngle", List.of("110", "20")),
          Map.entry("maestro:frameRate", List.of("30", "5")),
          Map.entry("maestro:resolution", List.of("\"64 36\"", "\"32 18\"")),
          Map.entry("maestro:luminousIntensity", List.of("300", "100")),
          Map.entry("maestro:beamAngle", List.of("120", "20")),
          Map.entry("maestro:shades", List.of("home:south-window", "home:north-window")),
          Map.entry("maestro:openingFrom", List.of("\"4 1\"", "\"4 0.3\"")),
          Map.entry("maestro:openingTo", List.of("\"4 2\"", "\"4 2.7\"")),
          Map.entry(":minimumIlluminance", List.of("72", "150")),
          Map.entry(":maximumIlluminance", List.of("2000", "80")),
          Map.entry(":power", List.of("5", "10")),
          Map.entry(":speaksFor", List.of("home:west", "home:east")),
          Map.entry(":side", List.of("home:west , home:east", "home:west")),
          Map.entry(":locked", List.of("false", "true")),
          Map.entry(":gripperOpening", List.of("0.098", "0.05")),
          Map.entry(":reach", List.of("0.5", "0.7")),
          Map.entry(":reachHeight", List.of("0.5", "0.01")),
          Map.entry(":payload", List.of("0.5", "0.05")),
          Map.entry(":speed", List.of("0.8", "0.2")));

  /** What is the platform's business alone, and why; it has to be in the description at least. */
  private static final Map<String, String> ONLY_PLANNED_WITH =
      Map.of(
          ":power",
              "what a lamp's light costs is a matter of prices; no energy is simulated for it",
          ":speaksFor", "of which place a measurement is believed, the sensor does not know",
          ":side",
              "which zones a plan may pass between; the simulated opening is where it is drawn");

  /** The same of devices of which it says no more than where they are. */
  private static final Set<String> PLACED = Set.of("Appliance", "Clock", "Television");

  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/bob#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/bob> a maestro:Home ; rdfs:label "bob"@en .
      home:west a maestro:Room , maestro:Zone ; maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:height 2.5 .
      home:east a maestro:Room , maestro:Zone ; maestro:outline "4 0, 8 0, 8 4, 4 4" ; maestro:height 2.5 .
      home:door a maestro:Door ; maestro:openingFrom "4 3" ; maestro:openingTo "4 3.9" ;
        :side home:west , home:east ; :open true .
      home:south-window a maestro:Window ; maestro:glassFrom "1 0 1" ; maestro:glassTo "3 0 2" .
      home:north-window a maestro:Window ; maestro:glassFrom "1 4 1" ; maestro:glassTo "3 4 2" .
      home:dock a :ChargingStation ; maestro:referencePoint "1 3.4 0" .
      home:Cup a :Item ; :colour "green" ; :size "0.07 0.07 0.1" ; :mass 0.2 .
      home:Ada a :Person ; :colour "blue" ; :size "0.5 0.5 1.2" .
      home:light a :Lamp ; maestro:pose "2 2 2.4" ; maestro:luminousIntensity 600 ;
        maestro:beamAngle 150 ; :power 5 .
      """;

  private static final Model VOCABULARY = vocabulary();

  private static final Map<String, List<String>> USUAL_TRACES = new HashMap<>();

  private static Model vocabulary() {
    Model model = ModelFactory.createDefaultModel();
    model.read(new StringReader(HomeLoader.shippedVocabulary()), DOMAIN, "TURTLE");
    return model;
  }

  /** By device class with a driver of its own or from above, what its devices have. */
  private static Map<String, Set<String>> has() {
    Map<String, Set<String>> has = new TreeMap<>();
    Resource device = VOCABULARY.createResource(MAESTRO + "Device");
    VOCABULARY
        .listSubjectsWithProperty(RDFS.subClassOf)
        .filterKeep(type -> isUnder(type, device))
        .forEach(type -> has.put(type.getLocalName(), ofClass(type)));
    return has;
  }

  private static boolean isUnder(Resource type, Resource ancestor) {
    return type.equals(ancestor)
        || type.listProperties(RDFS.subClassOf)
            .filterKeep(above -> isUnder(above.getResource(), ancestor))
            .hasNext();
  }

  private static Set<String> ofClass(Resource type) {
    Set<String> properties = new TreeSet<>();
    type.listProperties(VOCABULARY.createProperty(MAESTRO, "has"))
        .forEach(statement -> properties.add(prefixed(statement.getResource())));
    type.listProperties(RDFS.subClassOf)
        .forEach(above -> properties.addAll(ofClass(above.getResource())));
    return properties;
  }

  private static String prefixed(Resource property) {
    return (property.getURI().startsWith(DOMAIN) ? ":" : "maestro:") + property.getLocalName();
  }

  static Stream<Arguments> everyPropertyOfEveryClass() {
    return has().entrySet().stream()
        .flatMap(type -> type.getValue().stream().map(own -> Arguments.of(type.getKey(), own)));
  }

  static Set<String> everyPropertyOfOtherClasses() {
    return has().keySet();
  }

  @ParameterizedTest
  @MethodSource
  void everyPropertyOfEveryClass(String type, String property) {
    Home changed = changed(type, property);

    if (ONLY_PLANNED_WITH.containsKey(property) || isOnlyPlaced(type, property)) {
      assertThat(described(changed)).isNotEqualTo(described(usual(type)));
    } else {
      assertThat(trace(changed))
          .isNotEqualTo(USUAL_TRACES.computeIfAbsent(type, usual -> trace(usual(usual))));
    }
  }

  private static boolean isOnlyPlaced(String type, String property) {
    return PLACED.contains(type) && property.equals("maestro:pose");
  }

  @ParameterizedTest
  @MethodSource
  void everyPropertyOfOtherClasses(String type) {
    Map<String, Set<String>> has = has();
    Set<String> others = new TreeSet<>();
    has.values().forEach(others::addAll);
    others.removeAll(has.get(type));
    Map<String, String> stated = new TreeMap<>();
    others.forEach(other -> stated.put(other, VALUES.get(other).get(0)));

    assertThatThrownBy(() -> home(type, stated))
        .isInstanceOfSatisfying(
            HomeFaultException.class,
            refused ->
                assertThat(
                        refused.faults().stream()
                            .filter(fault -> fault.problem().startsWith("is stated in vain"))
                            .map(Fault::property))
                    .containsExactlyInAnyOrderElementsOf(others));
  }

  /** All that the class has. */
  private static Home usual(String type) {
    return home(type, Map.of());
  }

  /** The same with another value of one property. */
  private static Home changed(String type, String property) {
    return home(type, Map.of(property, VALUES.get(property).get(1)));
  }

  private static Home home(String type, Map<String, String> others) {
    StringBuilder text = new StringBuilder(HOME).append("home:probe a :").append(type);
    Map<String, String> stated = new TreeMap<>();
    has().get(type).forEach(own -> stated.put(own, VALUES.get(own).get(0)));
    stated.putAll(others);
    stated.forEach((name, turtle) -> text.append(" ; ").append(name).append(' ').append(turtle));
    return new HomeLoader().load(text.append(" .\n").toString(), "bob.ttl");
  }

  private static String described(Home home) {
    return new DescriptionWriter(home).write(home.devices().get("probe"));
  }

  /** What comes of each of its features, when, and what is then so in the world. */
  private static List<String> trace(Home home) {
    Device probe = home.devices().get("probe");
    List<String> trace = new ArrayList<>();
    try (Homes homes = new Homes(home, scene(home, probe), 1)) {
      light(homes, trace);
      probe.features().stream()
          .sorted(Comparator.comparing(StatedPropertiesTest::isOfZones))
          .forEach(
              feature -> {
                Answer answer = homes.call("probe", feature.name(), parameters(homes, feature));
                trace.add(
                    feature.name()
                        + answer.result().map(Result::outcome)
                        + answer.result().flatMap(Result::error)
                        + answer.values()
                        + homes.clock.now());
              });
      light(homes, trace);
      trace.addAll(homes.facts("probe"));
      if (has(probe, "resolution")) {
        var photo = homes.simulated.photo("probe");
        trace.add(photo.width() + " by " + photo.height());
      }
    }
    return trace;
  }

  private static boolean has(Device device, String property) {
    return device.individual().properties().containsKey(property);
  }

  private static boolean isOfZones(FeatureType feature) {
    return feature.inputs().stream().anyMatch(input -> input.types().contains("Zone"));
  }

  private static void light(Homes homes, List<String> trace) {
    for (double x = 0.5; x < 8; x += 0.5) {
      for (double y : new double[] {0.5, 1.5, 2.3, 3.5}) {
        trace.add(String.valueOf(homes.world().lux(new Position(x, y, 0))));
      }
    }
  }

  private static Map<String, Object> parameters(Homes homes, FeatureType feature) {
    Map<String, Object> parameters = new HashMap<>();
    for (Parameter input : feature.inputs()) {
      if (!input.optional()) {
        parameters.put(input.name(), value(homes, input));
      }
    }
    return parameters;
  }

  private static Object value(Homes homes, Parameter input) {
    if (!input.oneOf().isEmpty()) {
      return 1.0;
    }
    Map<String, Object> pointer = new HashMap<>();
    if (input.types().contains("Zone")) {
      pointer.putAll(Homes.ref("east"));
      pointer.put("outline", "4 0, 8 0, 8 4, 4 4");
    } else if (input.types().contains("ChargingStation")) {
      pointer.putAll(Homes.ref("dock"));
      pointer.put("referencePoint", List.of(1, 3.4, 0));
    } else {
      pointer.putAll(homes.at("Cup"));
      pointer.putAll(Map.of("colour", "green", "size", "0.07 0.07 0.1", "mass", 0.2));
    }
    return pointer;
  }

  private static Scene scene(Home home, Device probe) {
    StringBuilder text =
        new StringBuilder(
            "@prefix scene: <%s> .\n@base <https://w3id.org/maestro/home/bob> .\n"
                .formatted(SceneLoader.NAMESPACE));
    text.append("<#Cup> scene:position \"2 2 0.02\" ; scene:radius 0.04 ; scene:mass 0.2 .\n");
    text.append("<#dock> scene:charges true .\n<#door> scene:open true .\n");
    boolean isShutter = probe.individual().classes().contains("Shutter");
    if (isShutter || probe.individual().classes().contains("Clock")) {
      text.append("<> scene:latitude 50 ; scene:dayOfYear 81 ; scene:solarTime \"12:00\" .\n");
    }
    if (isShutter) {
      text.append("<#probe> scene:opening 0.5 .\n");
    } else {
      text.append("<#light> scene:level 1.0 .\n<#west> scene:ambientLux 20 .\n");
    }
    if (probe.individual().classes().contains("PresenceSensor")) {
      text.append("<#Ada> scene:position \"2 1 0\" ; scene:radius 0.25 .\n");
    }
    if (probe.individual().classes().contains("Door")) {
      text.append("<#probe> scene:open false .\n");
    }
    if (probe.individual().classes().contains("Thing")) {
      text.append("<#probe> scene:position \"0.8 0.8 0\" .\n");
    }
    return SceneLoader.load(
        "probe", new ByteArrayInputStream(text.toString().getBytes(StandardCharsets.UTF_8)), home);
  }
}
