package org.maestro.knowledge.belief;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentHashMap;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Geometry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Positions;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The geometry of a home, with movable things where a snapshot knows them. */
public final class HomeMeasures implements Measures {

  /** Poses are read again and again, and there are not many at a time. */
  private static final int MOST_POSES = 512;

  private final Geometry geometry;
  private final Map<String, Pose> poses = new ConcurrentHashMap<>();

  public HomeMeasures(Home home) {
    this.geometry = new Geometry(home);
  }

  @Override
  public boolean isNumber(String function) {
    return Geometry.isNumber(function);
  }

  @Override
  public boolean isTruth(String function) {
    return Geometry.isTruth(function);
  }

  @Override
  public OptionalDouble number(String function, List<Term> arguments, Snapshot snapshot) {
    return geometry.number(function, arguments, positions(snapshot));
  }

  /** A place without outline is a carrier, of which no position tells what is in it. */
  @Override
  public Truth truth(String function, List<Term> arguments, Snapshot snapshot) {
    boolean outlined =
        arguments.size() > 1
            && arguments.get(1) instanceof Term.Name place
            && geometry.outline(place.text()).isPresent();
    return outlined ? geometry.truth(function, arguments, positions(snapshot)) : Truth.UNKNOWN;
  }

  private Positions positions(Snapshot snapshot) {
    return name ->
        snapshot
            .value(Declarations.POSITION, List.of(new Term.Name(name)))
            .filter(Term.Text.class::isInstance)
            .map(value -> pose(((Term.Text) value).value()));
  }

  private Pose pose(String text) {
    if (poses.size() > MOST_POSES) {
      poses.clear();
    }
    return poses.computeIfAbsent(text, Pose::parse);
  }
}
