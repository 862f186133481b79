package org.maestro.sim.parameters;

/**
 * A sensor that tells persons apart, with its errors. No maker states such numbers for homes: all
 * of them are assumed.
 */
public record RecognitionData(
    @Quantity(
            meaning = "time between two looks",
            unit = "s",
            source = "assumed; no maker states such numbers for homes")
        double everySeconds,
    @Quantity(
            meaning = "how often it does not notice a person who is there, 0 to 1",
            unit = "1",
            source = "assumed")
        double missShare,
    @Quantity(
            meaning = "how often it takes a person to be there who is not, 0 to 1",
            unit = "1",
            source = "assumed")
        double falseShare,
    @Quantity(
            meaning =
                "how long an error lasts, as it comes from where somebody stands or how she turns",
            unit = "s",
            source = "assumed")
        double errorSeconds) {

  /** A camera: faces turn away. */
  static final RecognitionData OF_FACES = new RecognitionData(1, 0.1, 0.005, 10);

  /** A receiver of radio: phones lie in other rooms, and walls let through. */
  static final RecognitionData OF_PHONES = new RecognitionData(5, 0.3, 0.05, 30);

  public RecognitionData {
    PhysicalParameters.positive("recognition.everySeconds", everySeconds);
    PhysicalParameters.positive("recognition.errorSeconds", errorSeconds);
    PhysicalParameters.share("recognition.missShare", missShare);
    PhysicalParameters.share("recognition.falseShare", falseShare);
  }
}
