// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace whipple
{
  /// What a key is called in a message.
  inline const std::string &
  registered_name(const std::string &key)
  {
    return key;
  }
  inline const std::string &
  registered_name(const std::pair<int, std::string> &key)
  {
    return key.second;
  }

  /// All things of one kind that can be chosen (models, shapes, stage ends, criteria ...). Each stands in a file of its
  /// own and registers itself there, before main(), by one line; never changed afterwards. A kind is a class that
  /// derives from this and adds what else can be asked of it; it also tells registries with like entries apart.
  /// @tparam Key name; or place in an order, then name
  template <typename Kind, typename EntryOfKind, typename KeyOfKind = std::string>
  class Registry
  {
  public:
    using Entry = EntryOfKind;
    using Key   = KeyOfKind;

    /// In the order of the keys.
    static const std::map<Key, Entry> &
    all()
    {
      return entries();
    }

    /// Makes one known.
    class Registered
    {
    public:
      /// @throws std::logic_error, and so ends the program before main(), if there is one with that key
      Registered(const Key &key, Entry entry)
      {
        if (!entries().emplace(key, std::move(entry)).second)
          throw std::logic_error("'" + registered_name(key) + "' is registered twice");
      }
    };

  private:
    static std::map<Key, Entry> &
    entries()
    {
      static std::map<Key, Entry> map;
      return map;
    }
  };
} // namespace whipple
