package org.maestro.sim.parameters;

/** How persons walk, and what they do who go about of their own accord. All of it is assumed. */
public record PersonData(
    @Quantity(meaning = "speed of a walking person", unit = "m/s", source = "assumed: a slow walk")
        double speed,
    @Quantity(
            meaning = "how often who goes about looks for what came in the way",
            unit = "s",
            source = "assumed")
        double lookSeconds,
    @Quantity(meaning = "how far ahead she then looks", unit = "s", source = "assumed")
        double aheadSeconds,
    @Quantity(
            meaning = "how long she waits for the way to be free, before she looks for another",
            unit = "s",
            source = "assumed")
        double patienceSeconds,
    @Quantity(
            meaning = "how far from her middle she takes things",
            unit = "m",
            source = "assumed: an arm's length before a body of 0.25 m")
        double reach,
    @Quantity(meaning = "time to take a thing, or to put it down", unit = "s", source = "assumed")
        double handlingSeconds,
    @Quantity(
            meaning = "radius of the largest thing that she takes",
            unit = "m",
            source = "assumed")
        double largestTaken,
    @Quantity(
            meaning = "mass of the heaviest thing that she takes",
            unit = "kg",
            source = "assumed")
        double heaviestTaken,
    @Quantity(meaning = "how often she next takes a thing, 0 to 1", unit = "1", source = "assumed")
        double takeShare,
    @Quantity(
            meaning = "how often she next stands in a door, 0 to 1",
            unit = "1",
            source = "assumed")
        double doorShare) {
  static final PersonData USUAL = new PersonData(0.8, 0.25, 0.5, 2, 0.7, 1, 0.15, 3, 0.3, 0.2);

  public PersonData {
    PhysicalParameters.positive("person.speed", speed);
    PhysicalParameters.positive("person.lookSeconds", lookSeconds);
    PhysicalParameters.positive("person.patienceSeconds", patienceSeconds);
    PhysicalParameters.share("person.takeShare", takeShare);
    PhysicalParameters.share("person.doorShare", doorShare);
  }
}
