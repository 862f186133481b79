package org.maestro.sim.parameters;

import java.util.Map;
import org.maestro.sim.scene.SimulationException;

/**
 * Every number of the simulated physics, each with its source; "assumed" means stated here and
 * nowhere measured. Each can be given another value by its name ({@link PhysicalSettings}).
 */
public record PhysicalParameters(
    @Quantity(
            meaning =
                "whether the shutters of a home are there; without them its windows stand free",
            unit = "true or false",
            source = "a condition, not a measure")
        boolean shutters,
    CameraData camera,
    ColourData colour,
    ImageData image,
    TurnData turn,
    SensorData sensor,
    FacadeData facade,
    PresenceData presence,
    RecognitionData recognition,
    RecognitionData phone,
    LampData lamp,
    BaseData base,
    ScannerData scanner,
    WheelData wheels,
    ArmData arm,
    GripperData gripper,
    BatteryData battery,
    DriveData drives,
    SignalData signal,
    ClimateData climate,
    ThermometerData thermometer,
    SpeechData speech,
    PersonData person) {

  public static PhysicalParameters standard() {
    return new PhysicalParameters(
        true,
        CameraData.LIFECAM,
        ColourData.USUAL,
        ImageData.USUAL,
        TurnData.YOUBOT,
        SensorData.TSL2561,
        FacadeData.USUAL,
        PresenceData.USUAL,
        RecognitionData.OF_FACES,
        RecognitionData.OF_PHONES,
        LampData.HUE,
        BaseData.YOUBOT,
        ScannerData.URG,
        WheelData.YOUBOT,
        ArmData.YOUBOT,
        GripperData.USUAL,
        BatteryData.YOUBOT,
        DriveData.USUAL,
        SignalData.USUAL,
        ClimateData.USUAL,
        ThermometerData.USUAL,
        SpeechData.USUAL,
        PersonData.USUAL);
  }

  public PhysicalParameters with(CameraData other) {
    return new PhysicalParameters(
        shutters,
        other,
        colour,
        image,
        turn,
        sensor,
        facade,
        presence,
        recognition,
        phone,
        lamp,
        base,
        scanner,
        wheels,
        arm,
        gripper,
        battery,
        drives,
        signal,
        climate,
        thermometer,
        speech,
        person);
  }

  public PhysicalParameters with(SensorData other) {
    return new PhysicalParameters(
        shutters,
        camera,
        colour,
        image,
        turn,
        other,
        facade,
        presence,
        recognition,
        phone,
        lamp,
        base,
        scanner,
        wheels,
        arm,
        gripper,
        battery,
        drives,
        signal,
        climate,
        thermometer,
        speech,
        person);
  }

  public PhysicalParameters with(BaseData other) {
    return new PhysicalParameters(
        shutters,
        camera,
        colour,
        image,
        turn,
        sensor,
        facade,
        presence,
        recognition,
        phone,
        lamp,
        other,
        scanner,
        wheels,
        arm,
        gripper,
        battery,
        drives,
        signal,
        climate,
        thermometer,
        speech,
        person);
  }

  public PhysicalParameters with(ArmData other) {
    return new PhysicalParameters(
        shutters,
        camera,
        colour,
        image,
        turn,
        sensor,
        facade,
        presence,
        recognition,
        phone,
        lamp,
        base,
        scanner,
        wheels,
        other,
        gripper,
        battery,
        drives,
        signal,
        climate,
        thermometer,
        speech,
        person);
  }

  /** The same with other settings by name, such as {@code world.camera.noise} and {@code 0.05}. */
  public PhysicalParameters with(Map<String, String> settings) {
    return PhysicalSettings.apply(this, settings);
  }

  /** The same of what is a share. */
  static void share(String name, double value) {
    if (!(value >= 0 && value <= 1)) {
      throw new SimulationException("The setting world.%s lies between 0 and 1.".formatted(name));
    }
  }

  /** A record that is made by name says what is wrong with a value. */
  static void positive(String name, double value) {
    if (!(value > 0)) {
      throw new SimulationException("The setting world.%s is more than 0.".formatted(name));
    }
  }
}
