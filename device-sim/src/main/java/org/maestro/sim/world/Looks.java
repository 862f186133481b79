package org.maestro.sim.world;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.maestro.hal.sight.Appearance;
import org.maestro.hal.sight.Paint;
import org.maestro.hal.sight.Size;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sim.scene.Scene;
import org.maestro.sl.Term;

/**
 * The colour and size of things, as the scene states them, or else as a value in the home reads:
 * the name of a colour, three lengths. Immutable.
 */
public final class Looks {

  private static final Set<String> OTHER_TEXTS =
      Set.of("pose", "position", "referencePoint", "glassFrom", "glassTo");
  private static final Size USUAL = new Size(0.08, 0.08, 0.1);

  private final Map<String, Paint> paints;
  private final Map<String, Size> sizes;

  public Looks(Home home, Scene scene) {
    Map<String, Paint> colours = new TreeMap<>();
    Map<String, Size> measures = new TreeMap<>();
    home.individuals()
        .forEach(
            (name, individual) -> {
              colour(individual).ifPresent(paint -> colours.put(name, paint));
              size(individual).ifPresent(size -> measures.put(name, size));
            });
    scene
        .entries()
        .forEach((name, entry) -> entry.colour().ifPresent(paint -> colours.put(name, paint)));
    this.paints = Collections.unmodifiableMap(colours);
    this.sizes = Collections.unmodifiableMap(measures);
  }

  public Paint paint(String name) {
    return paints.getOrDefault(name, Paint.GREY);
  }

  public Size size(String name) {
    return sizes.getOrDefault(name, USUAL);
  }

  /** How all look of which somebody states a colour. */
  public Map<String, Appearance> known() {
    Map<String, Appearance> known = new TreeMap<>();
    paints.forEach((name, paint) -> known.put(name, new Appearance(paint, size(name))));
    return known;
  }

  private static Optional<Paint> colour(Individual individual) {
    return texts(individual).stream().flatMap(text -> Paint.parse(text).stream()).findFirst();
  }

  private static Optional<Size> size(Individual individual) {
    return texts(individual).stream().flatMap(text -> Size.parse(text).stream()).findFirst();
  }

  /** As what is said of a thing reads, by the property's name; lists are lengths. */
  public static Optional<Appearance> stated(Map<String, Object> properties) {
    return Appearance.read(
        properties.entrySet().stream()
            .filter(property -> !OTHER_TEXTS.contains(property.getKey()))
            .map(
                property ->
                    property.getValue() instanceof List<?> lengths
                        ? lengths.stream().map(String::valueOf).collect(Collectors.joining(" "))
                        : String.valueOf(property.getValue()))
            .toList());
  }

  private static List<String> texts(Individual individual) {
    return individual.properties().entrySet().stream()
        .filter(property -> !OTHER_TEXTS.contains(property.getKey()))
        .flatMap(property -> property.getValue().stream())
        .filter(Term.Text.class::isInstance)
        .map(term -> ((Term.Text) term).value())
        .toList();
  }
}
