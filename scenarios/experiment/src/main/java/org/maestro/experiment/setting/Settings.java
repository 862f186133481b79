package org.maestro.experiment.setting;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The values set for a run of an experiment, each of them checked. Immutable. */
public final class Settings {
  private final Map<String, Setting> known = new LinkedHashMap<>();
  private final Map<String, String> values = new TreeMap<>();

  /**
   * @param given values by name; what is not given has its usual value
   * @throws SettingException when one is unknown or has a value that it may not have
   */
  public Settings(List<Setting> known, Map<String, String> given) {
    known.forEach(setting -> this.known.put(setting.name(), setting));
    known.forEach(setting -> values.put(setting.name(), setting.usual()));
    given.forEach(
        (name, value) -> {
          if (!this.known.containsKey(name)) {
            throw new SettingException(
                "Nothing here is called %s; what can be set is %s."
                    .formatted(name, String.join(", ", near(name))));
          }
          this.known.get(name).check(value);
          values.put(name, value);
        });
  }

  /**
   * What has the same first words, or the same last ones; all, shortened to groups, when nothing
   * has.
   */
  private List<String> near(String name) {
    String[] words = name.split("\\.");
    List<String> alike =
        known.keySet().stream()
            .filter(
                other ->
                    words.length > 1 && other.startsWith(words[0] + "." + words[1] + ".")
                        || other.endsWith("." + name))
            .toList();
    return alike.isEmpty()
        ? known.keySet().stream().map(Settings::shortened).distinct().toList()
        : alike;
  }

  private static String shortened(String name) {
    String[] words = name.split("\\.");
    return words.length > 2 ? words[0] + "." + words[1] + ".…" : name;
  }

  public double number(String name) {
    return Double.parseDouble(text(name));
  }

  public boolean truth(String name) {
    return Boolean.parseBoolean(text(name));
  }

  private String text(String name) {
    String value = values.get(name);
    if (value == null) {
      throw new IllegalArgumentException("No setting " + name + " was declared.");
    }
    return value;
  }

  /** All that can be set, in the order of their declaration. */
  public List<Setting> known() {
    return List.copyOf(known.values());
  }

  /** The value as it was written. */
  public String value(Setting setting) {
    return text(setting.name());
  }

  /** The same with another value of a setting, which need not have been among them. */
  public Settings with(Setting setting, String value) {
    Map<String, Setting> more = new LinkedHashMap<>(known);
    more.put(setting.name(), setting);
    Map<String, String> changed = new TreeMap<>(values);
    changed.put(setting.name(), value);
    return new Settings(List.copyOf(more.values()), changed);
  }
}
