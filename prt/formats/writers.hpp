// The writers and readers of each format, for the tables of formats.cpp. What the numbers mean: FORMATS.md.
#pragma once
#include "prt/formats/formats.hpp"

namespace sh::prt::formats {

std::string write_threejs(const EngineLight& light);
std::optional<Triples> read_threejs(const Document& document);

std::string write_filament(const EngineLight& light);
std::optional<Triples> read_filament(const Document& document);
std::string write_filament_ktx(const EngineLight& light);
std::optional<Triples> read_filament_ktx(const Document& document);

std::string write_gltf_light(const EngineLight& light);
std::optional<Triples> read_gltf_light(const Document& document);

std::string write_unity(const EngineLight& light);
std::string write_unity_code(const EngineLight& light);
std::optional<Triples> read_unity(const Document& document);

std::string write_unreal(const EngineLight& light);
std::string write_unreal_code(const EngineLight& light);
std::optional<Triples> read_unreal(const Document& document);

std::string write_godot(const EngineLight& light);
std::string write_godot_code(const EngineLight& light);
std::optional<Triples> read_godot(const Document& document);

std::string write_usd(const EngineLight& light);
std::optional<Triples> read_usd(const Document& document);

std::string write_glb(const Transfer& transfer);
std::string write_transfer_ply(const Transfer& transfer);
std::string write_npz(const Transfer& transfer);

}  // namespace sh::prt::formats
